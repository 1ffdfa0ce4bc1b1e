/** A model or texture that could not be loaded. The message is a sentence for the visitor. */
export class AssetError extends Error {
  override readonly name = "AssetError";
}

/**
 * Error in a file, thrown where the file's name is not known. The message continues a sentence after the name: "is
 * cut short".
 */
export class Flaw extends Error {
  override readonly name = "Flaw";
}

export function assetError(file: string, cause: unknown): AssetError {
  if (cause instanceof AssetError) return cause;
  if (cause instanceof Flaw) return new AssetError(`${file} ${cause.message}.`, { cause });
  const reason = cause instanceof Error && cause.message !== "" ? ` (${cause.message})` : "";
  return new AssetError(`${file} cannot be read${reason}.`, { cause });
}

/** Of a chunk that is not to be had: one message for all browsers, without its address. */
export function missCode(cause: unknown): never {
  const sentence = "A part of the program could not be fetched. Reload the page to try again.";
  throw new AssetError(sentence, { cause });
}
