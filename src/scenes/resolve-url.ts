/** The absolute URL, or null where the text is none. (`URL.canParse` is newer than the oldest browsers.) */
export function resolveUrl(text: string, base: string): string | null {
  try {
    return new URL(text, base).href;
  } catch {
    return null;
  }
}
