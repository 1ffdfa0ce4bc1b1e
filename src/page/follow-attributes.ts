import type { SettingName } from "../settings.js";

/** Calls a function now, and whenever one of these attributes was set: methods set them, too. */
export function followAttributes(
  element: Element,
  names: readonly SettingName[],
  show: () => void,
): void {
  show();
  new MutationObserver(show).observe(element, { attributeFilter: names as SettingName[] });
}
