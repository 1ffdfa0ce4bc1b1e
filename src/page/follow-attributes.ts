/** Calls a function now, and whenever an attribute of the element was set: methods set them, too. */
export function followAttributes(element: Element, show: () => void): void {
  show();
  new MutationObserver(show).observe(element, { attributes: true });
}
