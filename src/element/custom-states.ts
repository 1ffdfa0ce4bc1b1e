/** Custom states of the element; the manifest describes each. */
export type StateName = "loading" | "lit" | "walking" | "playing" | "alone";

/**
 * Custom states: `:state(lit)` where the browser has custom states, elsewhere the attribute `state-lit`.
 *
 * Firefox before 126 and Safari before 17.4 have none; Chromium before 125 takes only names that begin with
 * two dashes.
 */
export class CustomStates {
  readonly #host: Element;
  readonly #custom: CustomStateSet | null;
  readonly #names = new Set<StateName>();

  constructor(host: Element, internals: ElementInternals) {
    this.#host = host;
    this.#custom = customStates(internals);
  }

  has(name: StateName): boolean {
    return this.#names.has(name);
  }

  toggle(name: StateName, isOn: boolean): void {
    const change = isOn ? "add" : "delete";
    this.#names[change](name);
    if (this.#custom) this.#custom[change](name);
    else this.#host.toggleAttribute(`state-${name}`, isOn);
  }

  clear(): void {
    for (const name of [...this.#names]) this.toggle(name, false);
  }
}

function customStates({ states }: ElementInternals): CustomStateSet | null {
  try {
    states.add("loading");
    states.delete("loading");
    return states;
  } catch {
    return null;
  }
}
