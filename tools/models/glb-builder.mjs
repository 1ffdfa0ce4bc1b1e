/** Builds a glTF file by hand, for what no exporter writes. */

const COMPONENTS = new Map([
  [Int8Array, 5120],
  [Uint8Array, 5121],
  [Int16Array, 5122],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
  [Float32Array, 5126],
]);
const TYPES = { 1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4" };

const padded = (bytes, filler) => {
  const out = Buffer.alloc(Math.ceil(bytes.length / 4) * 4, filler);
  out.set(bytes);
  return out;
};

export class GlbBuilder {
  json = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [] }], nodes: [] };
  #chunks = [];
  #length = 0;

  /** Adds an entry to one of the file's lists and gives its number. */
  add(list, entry) {
    this.json[list] ??= [];
    this.json[list].push(entry);
    return this.json[list].length - 1;
  }

  view(bytes) {
    const view = this.add("bufferViews", {
      buffer: 0,
      byteOffset: this.#length,
      byteLength: bytes.length,
    });
    const chunk = padded(bytes, 0);
    this.#chunks.push(chunk);
    this.#length += chunk.length;
    return view;
  }

  /** Adds an accessor of so many numbers to an element. */
  accessor(array, size, { normalized = false } = {}) {
    const accessor = {
      bufferView: this.view(Buffer.from(array.buffer, array.byteOffset, array.byteLength)),
      componentType: COMPONENTS.get(array.constructor),
      count: array.length / size,
      type: TYPES[size],
      ...(normalized ? { normalized } : {}),
    };
    if (size === 3 && array instanceof Float32Array) {
      const column = (k) => Array.from(array).filter((_, i) => i % 3 === k);
      accessor.min = [0, 1, 2].map((k) => Math.min(...column(k)));
      accessor.max = [0, 1, 2].map((k) => Math.max(...column(k)));
    }
    return this.add("accessors", accessor);
  }

  /** Adds a node to the scene. */
  root(node) {
    const index = this.add("nodes", node);
    this.json.scenes[0].nodes.push(index);
    return index;
  }

  use(...extensions) {
    this.json.extensionsUsed = [...new Set([...(this.json.extensionsUsed ?? []), ...extensions])];
  }

  binary() {
    return Buffer.concat(this.#chunks);
  }

  glb() {
    const binary = this.binary();
    const json = { ...this.json, buffers: [{ byteLength: binary.length }] };
    return packGlb(json, binary);
  }
}

/** A .glb of any JSON and any bytes, true or not. */
export function packGlb(json, binary) {
  const text = padded(Buffer.from(typeof json === "string" ? json : JSON.stringify(json)), " ");
  const header = (...words) => {
    const bytes = Buffer.alloc(words.length * 4);
    for (const [i, word] of words.entries()) bytes.writeUInt32LE(word, i * 4);
    return bytes;
  };
  const chunks = [header(text.length, 0x4e4f534a), text];
  if (binary.length > 0) chunks.push(header(binary.length, 0x004e4942), binary);
  const body = Buffer.concat(chunks);
  return Buffer.concat([header(0x46546c67, 2, 12 + body.length), body]);
}

/** The JSON and the bytes of a .glb; what the JSON refers to need not be there. */
export function openGlb(bytes) {
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString("utf8", 20, 20 + length));
  return { json, binary: bytes.subarray(28 + length) };
}
