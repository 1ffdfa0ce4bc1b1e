const ATTRIBUTES = {
  role: "role",
  ariaLabel: "aria-label",
  ariaDescription: "aria-description",
} as const;
type Semantic = keyof typeof ATTRIBUTES;

/**
 * The element's own role, accessible name and description, each of which the page's attribute overrides.
 *
 * Where `ElementInternals` has no ARIA (Firefox before 119), it is the attribute itself, unless the page has
 * set it.
 */
export class DefaultSemantics {
  readonly #host: Element;
  readonly #internals: ElementInternals;
  readonly #own = new Map<Semantic, string>();

  constructor(host: Element, internals: ElementInternals) {
    this.#host = host;
    this.#internals = internals;
  }

  set(semantics: Readonly<Record<Semantic, string | null>>): void {
    for (const name of Object.keys(ATTRIBUTES) as Semantic[]) this.#set(name, semantics[name]);
  }

  #set(name: Semantic, value: string | null): void {
    if (name in this.#internals) {
      this.#internals[name] = value;
      return;
    }
    const attribute = ATTRIBUTES[name];
    const present = this.#host.getAttribute(attribute);
    if (present !== null && present !== this.#own.get(name)) return;
    if (value === null) {
      this.#own.delete(name);
      this.#host.removeAttribute(attribute);
    } else {
      this.#own.set(name, value);
      this.#host.setAttribute(attribute, value);
    }
  }
}
