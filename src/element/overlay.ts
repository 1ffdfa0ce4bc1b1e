import { createEnglish, Hint } from "./hint.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

/**
 * Overlay of the canvas: poster, progress bar, hint and failure, each of which the page may replace by a slot
 * of that name, and style as a part of that name; and the glow of a lone candle on the page.
 */
export class Overlay {
  readonly hint = new Hint();
  onFailureChange: () => void = () => {};
  readonly #glow = part("glow");
  #intensity = "";
  readonly #posterSlot = slot("poster");
  readonly #poster = document.createElement("img");
  readonly #progressSlot = slot("progress");
  readonly #progress = part("progress");
  readonly #failure = part("error");
  readonly #sentence = createEnglish("p");
  readonly #reload = createEnglish("button");

  constructor(root: ShadowRoot) {
    this.#poster.part.add("poster");
    this.#poster.onerror = () => {
      this.#poster.hidden = true; // no icon of a broken image
    };
    this.#posterSlot.append(this.#poster);
    this.#progressSlot.append(this.#progress);
    const errorSlot = slot("error", true);
    errorSlot.append(this.#sentence);
    this.#reload.part.add("reload");
    this.#reload.type = "button";
    this.#reload.textContent = "Reload";
    // Keys for the button must not reach the canvas, where they enter the room.
    for (const type of ["keydown", "keyup"]) {
      this.#reload.addEventListener(type, (event) => event.stopPropagation());
    }
    this.#failure.append(errorSlot);
    this.#failure.hidden = true;
    root.append(this.#glow, this.#posterSlot, this.#progressSlot, this.#failure, this.hint.element);
  }

  /** Whether an error message is shown in place of frames. */
  get isFailing(): boolean {
    return !this.#failure.hidden;
  }

  showPoster({ poster, loading }: Pick<ReflectedAttributes, "poster" | "loading">): void {
    this.#poster.hidden = poster === "";
    this.#poster.loading = loading;
    if (poster !== "") this.#poster.src = poster;
    this.#posterSlot.hidden = false;
  }

  /** Alternative text of the poster while it stands for the canvas; empty where another element has the name. */
  set posterAlt(alt: string) {
    this.#poster.alt = alt;
  }

  hidePoster(): void {
    this.#posterSlot.hidden = true;
  }

  showProgress(totalProgress: number): void {
    this.#progressSlot.hidden = false;
    this.#progress.style.inlineSize = `${100 * totalProgress}%`;
    this.#progress.classList.toggle("full", totalProgress === 1); // what comes next has no measure
  }

  hideProgress(): void {
    this.#progressSlot.hidden = true;
  }

  /**
   * Shows the warm light of a lone candle on the page around it, in proportion to the flame's intensity.
   *
   * @param luminousIntensity candela; followed in steps too small to see
   */
  glow(luminousIntensity: number): void {
    const intensity = (Math.round(Math.min(luminousIntensity, 1) * 64) / 64).toString();
    if (intensity === this.#intensity) return;
    this.#intensity = intensity;
    this.#glow.style.setProperty("--intensity", intensity);
  }

  /** Nothing goes on: without progress, hint and glow. */
  clear(): void {
    this.glow(0);
    this.hideProgress();
    this.hint.tell("");
  }

  /** Shows an error message in place of frames, with a reload button where that may help. */
  fail(sentence: string, urgency: "alert" | "status", reload: (() => void) | null = null): void {
    this.#failure.setAttribute("role", urgency);
    this.#sentence.textContent = sentence;
    this.#reload.onclick = reload;
    if (reload) this.#failure.append(this.#reload);
    else this.#reload.remove();
    this.#failure.hidden = false;
    this.onFailureChange();
  }

  clearFailure(): void {
    this.#failure.hidden = true;
    this.onFailureChange();
  }
}

function slot(name: string, isShown = false): HTMLSlotElement {
  const element = document.createElement("slot");
  element.name = name;
  element.hidden = !isShown;
  return element;
}

function part(name: string): HTMLElement {
  const element = document.createElement("div");
  element.part.add(name);
  return element;
}
