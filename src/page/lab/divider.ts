/** Steps of the keys, in per cent of the stage's width. */
const STEP = 2;
const LEAP = 10;

/** Divider of two views: a slider that is dragged, or moved by its keys. */
export class Divider {
  readonly #line: HTMLElement;
  readonly #stage: HTMLElement;
  #names: readonly [string, string] = ["", ""];
  #percent = 50;

  /** @param onEscape called on Esc, while the divider has the focus */
  constructor(line: HTMLElement, stage: HTMLElement, onEscape: () => void) {
    this.#line = line;
    this.#stage = stage;
    line.addEventListener("pointerdown", ({ pointerId }) => line.setPointerCapture(pointerId));
    line.addEventListener("pointermove", ({ pointerId, clientX }) => {
      if (line.hasPointerCapture(pointerId)) this.#moveTo(clientX);
    });
    line.addEventListener("keydown", (event) => {
      if (event.key === "Escape") onEscape();
      else if (!this.#pressKey(event.key)) return;
      event.preventDefault();
    });
  }

  /** @param names of what is on the left, and on the right */
  show(names: readonly [string, string]): void {
    this.#names = names;
    names.forEach((name, i) => {
      this.#line.children[i]?.replaceChildren(name);
    });
    if (!this.#line.isConnected) this.#stage.append(this.#line);
    document.body.classList.add("comparing");
    this.#set(this.#percent);
  }

  hide(): void {
    this.#line.remove();
    document.body.classList.remove("comparing");
  }

  #moveTo(clientX: number): void {
    const { left, width } = this.#stage.getBoundingClientRect();
    this.#set(((clientX - left) / width) * 100);
  }

  #pressKey(key: string): boolean {
    const targets: Readonly<Record<string, number>> = {
      ArrowLeft: this.#percent - STEP,
      ArrowDown: this.#percent - STEP,
      ArrowRight: this.#percent + STEP,
      ArrowUp: this.#percent + STEP,
      PageDown: this.#percent - LEAP,
      PageUp: this.#percent + LEAP,
      Home: 0,
      End: 100,
    };
    const target = targets[key];
    if (target === undefined) return false;
    this.#set(target);
    return true;
  }

  #set(percent: number): void {
    this.#percent = Math.min(Math.max(percent, 0), 100);
    const shown = Math.round(this.#percent);
    this.#line.setAttribute("aria-valuenow", String(shown));
    this.#line.setAttribute(
      "aria-valuetext",
      `${this.#names[0]} ${shown} %, ${this.#names[1]} ${100 - shown} %`,
    );
    this.#stage.style.setProperty("--divider", `${this.#percent}%`);
  }
}
