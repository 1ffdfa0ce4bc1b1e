import {
  type Look,
  type Motion,
  parseChoice,
  parseNumber,
  type Quality,
  type SceneName,
  SETTINGS,
} from "../settings.js";

// Where there is no DOM (a server that renders pages), the module still loads.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** The element's attributes as properties: text becomes what `SETTINGS` says it means, and back. */
export class ReflectedAttributes extends Base {
  static readonly observedAttributes: readonly string[] = Object.keys(SETTINGS);

  get scene(): SceneName {
    return parseChoice(SETTINGS.scene, this.getAttribute("scene"));
  }
  set scene(value: SceneName) {
    this.setAttribute("scene", value);
  }

  get loading(): "eager" | "lazy" {
    return parseChoice(SETTINGS.loading, this.getAttribute("loading"));
  }
  set loading(value: "eager" | "lazy") {
    this.setAttribute("loading", value);
  }

  get look(): Look {
    return parseChoice(SETTINGS.look, this.getAttribute("look"));
  }
  set look(value: Look) {
    this.setAttribute("look", value);
  }

  get quality(): Quality {
    return parseChoice(SETTINGS.quality, this.getAttribute("quality"));
  }
  set quality(value: Quality) {
    this.setAttribute("quality", value);
  }

  get controls(): boolean {
    return this.hasAttribute("controls");
  }
  set controls(value: boolean) {
    this.toggleAttribute("controls", Boolean(value));
  }

  get paused(): boolean {
    return this.hasAttribute("paused");
  }
  set paused(value: boolean) {
    this.toggleAttribute("paused", Boolean(value));
  }

  get sensitivity(): number {
    return parseNumber(SETTINGS.sensitivity, this.getAttribute("sensitivity"));
  }
  set sensitivity(value: number) {
    this.setAttribute("sensitivity", String(value));
  }

  get motion(): Motion {
    return parseChoice(SETTINGS.motion, this.getAttribute("motion"));
  }
  set motion(value: Motion) {
    this.setAttribute("motion", value);
  }

  get seed(): number {
    return parseNumber(SETTINGS.seed, this.getAttribute("seed"));
  }
  set seed(value: number) {
    this.setAttribute("seed", String(value));
  }

  get unlit(): boolean {
    return this.hasAttribute("unlit");
  }
  set unlit(value: boolean) {
    this.toggleAttribute("unlit", Boolean(value));
  }

  get wind(): number {
    return parseNumber(SETTINGS.wind, this.getAttribute("wind"));
  }
  set wind(value: number) {
    this.setAttribute("wind", String(value));
  }

  get windDirection(): number {
    return parseNumber(SETTINGS["wind-direction"], this.getAttribute("wind-direction"));
  }
  set windDirection(value: number) {
    this.setAttribute("wind-direction", String(value));
  }

  get gustiness(): number {
    return parseNumber(SETTINGS.gustiness, this.getAttribute("gustiness"));
  }
  set gustiness(value: number) {
    this.setAttribute("gustiness", String(value));
  }

  get wick(): number {
    return parseNumber(SETTINGS.wick, this.getAttribute("wick"));
  }
  set wick(value: number) {
    this.setAttribute("wick", String(value));
  }

  get exposure(): number {
    return parseNumber(SETTINGS.exposure, this.getAttribute("exposure"));
  }
  set exposure(value: number) {
    this.setAttribute("exposure", String(value));
  }

  get particles(): number {
    return parseNumber(SETTINGS.particles, this.getAttribute("particles"));
  }
  set particles(value: number) {
    this.setAttribute("particles", String(value));
  }

  get maxPixelRatio(): number {
    return parseNumber(SETTINGS["max-pixel-ratio"], this.getAttribute("max-pixel-ratio"));
  }
  set maxPixelRatio(value: number) {
    this.setAttribute("max-pixel-ratio", String(value));
  }

  get assetBase(): string {
    return this.getAttribute("asset-base") ?? "";
  }
  set assetBase(value: string) {
    this.setAttribute("asset-base", value);
  }

  get src(): string {
    return this.getAttribute("src") ?? "";
  }
  set src(value: string) {
    this.setAttribute("src", value);
  }

  get poster(): string {
    return this.getAttribute("poster") ?? "";
  }
  set poster(value: string) {
    this.setAttribute("poster", value);
  }

  get alt(): string {
    return this.getAttribute("alt") ?? SETTINGS.alt.default;
  }
  set alt(value: string) {
    this.setAttribute("alt", value);
  }

  // A property set before the element was defined hides the accessor: set it again through it.
  protected upgrade(name: string): void {
    if (!Object.hasOwn(this, name)) return;
    const element = this as unknown as Record<string, unknown>;
    const value = element[name];
    delete element[name];
    element[name] = value;
  }

  protected upgradeAttributes(): void {
    for (const name of Object.keys(SETTINGS)) this.upgrade(camelCase(name));
  }
}

function camelCase(name: string): string {
  return name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
}
