/** The warm light of a lone candle on the page around it, in proportion to the flame's intensity. */
export class Glow {
  readonly element = document.createElement("div");
  #intensity = "";

  constructor() {
    this.element.part.add("glow");
  }

  /** @param luminousIntensity candela; followed in steps too small to see */
  follow(luminousIntensity: number): void {
    const intensity = (Math.round(Math.min(luminousIntensity, 1) * 64) / 64).toString();
    if (intensity === this.#intensity) return;
    this.#intensity = intensity;
    this.element.style.setProperty("--intensity", intensity);
  }
}
