import {
  type CamelCase,
  camelCase,
  parseChoice,
  parseNumber,
  SETTING_NAMES,
  SETTINGS,
  type SettingName,
  type SettingValue,
} from "../settings.js";
import type { TypedListeners } from "./events.js";

/** The attributes as properties: typed by their rows in `SETTINGS`, defined below from the same rows. */
type AttributeProperties = {
  -readonly [Name in SettingName as CamelCase<Name>]: SettingValue<(typeof SETTINGS)[Name]>;
};

// Where there is no DOM (a server that renders pages), the module still loads.
const Base = (globalThis.HTMLElement ?? class {}) as unknown as {
  new (): Omit<HTMLElement, keyof TypedListeners> & TypedListeners & AttributeProperties;
};

/** The element's attributes as properties: text becomes the value that `SETTINGS` describes, and back. */
export class ReflectedAttributes extends Base {
  static readonly observedAttributes: readonly string[] = SETTING_NAMES;

  // A property set before the element was defined hides the accessor: set it again through it.
  protected upgradeProperties(others: readonly string[]): void {
    const element = this as unknown as Record<string, unknown>;
    for (const name of [...SETTING_NAMES.map(camelCase), ...others]) {
      if (!Object.hasOwn(this, name)) continue;
      const value = element[name];
      delete element[name];
      element[name] = value;
    }
  }
}

for (const name of SETTING_NAMES) {
  const setting = SETTINGS[name];
  Object.defineProperty(ReflectedAttributes.prototype, camelCase(name), {
    configurable: true,
    enumerable: true,
    get(this: Element) {
      const text = this.getAttribute(name);
      if (setting.kind === "flag") return text !== null;
      if (setting.kind === "number") return parseNumber(setting, text);
      return setting.kind === "choice" ? parseChoice(setting, text) : (text ?? setting.default);
    },
    set(this: Element, value: unknown) {
      // In templates, which set properties, `controls=""` means what it does in HTML.
      if (setting.kind === "flag") this.toggleAttribute(name, value === "" || !!value);
      else if (value == null) this.removeAttribute(name);
      else this.setAttribute(name, String(value));
    },
  });
}
