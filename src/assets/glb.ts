import { Flaw } from "./asset-error.js";

const MAGIC = 0x46546c67; // "glTF", little-endian
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const HEADER = 12;
const CHUNK_HEADER = 8;

/** JSON document of a .glb or .gltf file, and its binary chunk if it has one: glTF 2.0 specification, section 4.4. */
export function openContainer(bytes: Uint8Array<ArrayBuffer>) {
  if (bytes.byteLength === 0) throw new Flaw("is empty");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength >= 4 && view.getUint32(0, true) === MAGIC) return openBinary(bytes, view);
  const text = new TextDecoder().decode(bytes).trimStart();
  if (text.startsWith("<")) throw new Flaw("is a web page, not a model");
  if (!text.startsWith("{")) throw new Flaw("is not a glTF model");
  return { json: parse(text), binary: null };
}

function openBinary(bytes: Uint8Array<ArrayBuffer>, view: DataView) {
  if (bytes.byteLength < HEADER + CHUNK_HEADER)
    throw cutShort(bytes.byteLength, `at least ${HEADER + CHUNK_HEADER}`);
  const version = view.getUint32(4, true);
  if (version !== 2) throw new Flaw(`is glTF ${version}, and only glTF 2 can be read`);
  const length = view.getUint32(8, true);
  if (length > bytes.byteLength) throw cutShort(bytes.byteLength, `${length}`);
  if (length < bytes.byteLength) {
    throw new Flaw(`says that it has ${length} bytes, but has ${bytes.byteLength}`);
  }
  const chunks = chunksOf(bytes, view);
  const [first, second] = chunks;
  if (first?.type !== JSON_CHUNK) throw new Flaw("does not begin with its JSON chunk");
  return {
    json: parse(new TextDecoder().decode(first.bytes)),
    binary: second?.type === BINARY_CHUNK ? second.bytes : null,
  };
}

function chunksOf(bytes: Uint8Array<ArrayBuffer>, view: DataView) {
  const chunks: { readonly type: number; readonly bytes: Uint8Array<ArrayBuffer> }[] = [];
  let offset = HEADER;
  while (offset + CHUNK_HEADER <= bytes.byteLength) {
    const length = view.getUint32(offset, true);
    const begin = offset + CHUNK_HEADER;
    if (begin + length > bytes.byteLength) {
      throw new Flaw(`has a chunk of ${length} bytes that runs beyond its end`);
    }
    const type = view.getUint32(offset + 4, true);
    chunks.push({ type, bytes: bytes.subarray(begin, begin + length) });
    offset = begin + length;
  }
  return chunks;
}

const cutShort = (there: number, whole: string) =>
  new Flaw(`is cut short: ${there} of ${whole} bytes are there`);

function parse(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new Flaw("holds JSON that cannot be parsed", { cause });
  }
}
