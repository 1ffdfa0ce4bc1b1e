/** The part of the Keyboard Map API that is used; Chromium alone has it. */
interface LayoutSource {
  getLayoutMap?(): Promise<ReadonlyMap<string, string>>;
}

/** Name of a key on the visitor's own keyboard, by that on an English one, where its place is that of a letter. */
export type KeyName = (key: string) => string;

/** Keys are bound by their places on an English keyboard. */
export async function fetchKeyNames(
  { keyboard }: { readonly keyboard?: LayoutSource } = navigator as object,
): Promise<KeyName> {
  // A frame may not be allowed to ask.
  const layout = await keyboard?.getLayoutMap?.().catch(() => null);
  return (key) => layout?.get(`Key${key}`)?.toUpperCase() ?? key;
}

/** Names letters in the page as the visitor's own keyboard does. */
export async function nameKeys(
  caps: Iterable<Pick<HTMLElement, "textContent">>,
  names = fetchKeyNames(),
): Promise<KeyName> {
  const nameOf = await names;
  for (const cap of caps) {
    const name = nameOf(cap.textContent ?? "");
    if (name !== cap.textContent) cap.textContent = name; // a change may be announced
  }
  return nameOf;
}
