/** Window that shows a node: it may be another than the script's, which may be hidden, or on another monitor. */
export function windowOf({ ownerDocument }: Node): Window & typeof globalThis {
  return ownerDocument?.defaultView ?? window;
}
