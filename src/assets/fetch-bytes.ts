import { Flaw } from "./asset-error.js";

/** Largest file, bytes. */
const MOST_BYTES = 50e6;
const MEGABYTE = 1e6;

/** Content types of files that are no model, buffer or decoder. */
const FOREIGN_TYPE = /^(text\/(html|css|javascript)|image|video|audio|font)\b/;

export interface FetchOptions {
  readonly signal: AbortSignal;
  /** Content types that the server may not answer with. */
  readonly isForeign?: (type: string) => boolean;
  readonly onProgress?: (progress: number) => void;
  /** Called with the address that answered: another after a redirection. */
  readonly onAddress?: (url: string) => void;
}

/** Fetches a file, or throws a `Flaw`, or the signal's reason. */
export async function fetchBytes(
  url: URL,
  {
    signal,
    onProgress = () => {},
    onAddress = () => {},
    isForeign = (type) => FOREIGN_TYPE.test(type),
  }: FetchOptions,
): Promise<Uint8Array<ArrayBuffer>> {
  if (url.protocol === "data:") return embeddedBytes(url.href);
  const response = await fetch(url, { signal }).catch((cause: unknown) => {
    signal.throwIfAborted();
    throw new Flaw("could not be fetched", { cause });
  });
  if (response.url) onAddress(response.url);
  const total = Number(response.headers.get("content-length") ?? 0);
  try {
    checkResponse(response, total, isForeign);
    return await readBody(response, total, onProgress);
  } catch (error) {
    response.body?.cancel().catch(() => {});
    signal.throwIfAborted();
    if (error instanceof Flaw) throw error;
    throw new Flaw("broke off while it was fetched", { cause: error });
  }
}

function checkResponse(
  response: Response,
  total: number,
  isForeign: (type: string) => boolean,
): void {
  if (!response.ok) {
    const reason = `${response.status} ${response.statusText}`.trim();
    throw new Flaw(`could not be fetched: the server answers ${reason}`);
  }
  const type = response.headers.get("content-type")?.split(";")[0]?.trim().toLowerCase() ?? "";
  if (isForeign(type)) {
    const what = type === "text/html" ? "a web page" : "something else";
    throw new Flaw(`is ${what}, says its server (${type})`);
  }
  if (total > MOST_BYTES) throw tooLarge(`${(total / MEGABYTE).toFixed(0)} MB`);
}

async function readBody(
  response: Response,
  total: number,
  onProgress: (progress: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  if (!response.body) return new Uint8Array(await response.arrayBuffer());
  const chunks: Uint8Array<ArrayBuffer>[] = [];
  let received = 0;
  const reader = response.body.getReader();
  try {
    for (let read = await reader.read(); !read.done; read = await reader.read()) {
      chunks.push(read.value);
      received += read.value.byteLength;
      if (received > MOST_BYTES) throw tooLarge("more");
      // With a content encoding, Content-Length counts the encoded bytes.
      if (total > 0) onProgress(Math.min(1, received / total));
    }
  } finally {
    reader.releaseLock();
  }
  return new Uint8Array(await new Blob(chunks).arrayBuffer());
}

const tooLarge = (size: string) =>
  new Flaw(`is too large: ${size}, where ${MOST_BYTES / MEGABYTE} MB are the limit`);

/** Bytes of a data URL. Not by `fetch`: a content security policy may forbid that. */
function embeddedBytes(url: string): Uint8Array<ArrayBuffer> {
  const comma = url.indexOf(",");
  const data = url.slice(comma + 1);
  try {
    if (!/;base64$/i.test(url.slice(0, comma))) {
      return new TextEncoder().encode(decodeURIComponent(data));
    }
    const binary = atob(decodeURIComponent(data));
    return Uint8Array.from(binary, (character) => character.charCodeAt(0));
  } catch (cause) {
    throw new Flaw("is embedded, but not in base64 that can be read", { cause });
  }
}
