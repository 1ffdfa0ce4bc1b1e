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
  #custom: CustomStateSet | null = null;
  readonly #names = new Set<StateName>();

  constructor(host: Element, { states }: ElementInternals) {
    this.#host = host;
    try {
      states.add("loading");
      states.delete("loading");
      this.#custom = states;
    } catch {
      // The attributes do.
    }
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
