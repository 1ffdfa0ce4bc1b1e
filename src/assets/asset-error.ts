/** A model or texture that could not be loaded. The message is a sentence for the visitor. */
export class AssetError extends Error {
  override readonly name = "AssetError";
}

/**
 * A flaw of a file, found where its name is not known: the message goes on where the name
 * ends, as in "is cut short".
 */
export class Flaw extends Error {
  override readonly name = "Flaw";
}

/** The sentence for whatever went wrong with a file. */
export function assetError(file: string, cause: unknown): AssetError {
  if (cause instanceof AssetError) return cause;
  if (cause instanceof Flaw) return new AssetError(`${file} ${cause.message}.`, { cause });
  const reason = cause instanceof Error && cause.message !== "" ? ` (${cause.message})` : "";
  return new AssetError(`${file} cannot be read${reason}.`, { cause });
}
