/** The part of the Keyboard Map API that is used; Chromium alone has it. */
interface LayoutSource {
  getLayoutMap?(): Promise<ReadonlyMap<string, string>>;
}

/** Names letters in the page as the visitor's own keyboard does: keys are bound by their places on an English one. */
export async function nameKeys(
  caps: Iterable<Pick<HTMLElement, "textContent">>,
  { keyboard }: { readonly keyboard?: LayoutSource } = navigator as object,
): Promise<void> {
  // A frame may not be allowed to ask.
  const layout = await keyboard?.getLayoutMap?.().catch(() => null);
  for (const cap of caps) {
    cap.textContent = layout?.get(`Key${cap.textContent}`)?.toUpperCase() ?? cap.textContent;
  }
}
