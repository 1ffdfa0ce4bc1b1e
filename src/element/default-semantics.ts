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
  readonly #own: Partial<Record<Semantic, string | null>> = {};

  constructor(host: Element, internals: ElementInternals) {
    this.#host = host;
    this.#internals = internals;
  }

  set(semantics: Readonly<Record<Semantic, string | null>>): void {
    for (const [name, attribute] of Object.entries(ATTRIBUTES) as [Semantic, string][]) {
      const value = semantics[name];
      const present = this.#host.getAttribute(attribute);
      if (name in this.#internals) {
        this.#internals[name] = value;
      } else if (present === null || present === this.#own[name]) {
        this.#own[name] = value;
        if (value === null) this.#host.removeAttribute(attribute);
        else this.#host.setAttribute(attribute, value);
      }
    }
  }
}
