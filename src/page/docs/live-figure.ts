import type { Camera, CandleFlameElement, Feature } from "../../candle-flame-element.js";
import { SETTINGS } from "../../settings.js";
import { find } from "../find.js";

/** A room this many screens away gives its memory back; it comes again when the reader does. */
const FAR = "150%";

/**
 * A figure made of the element itself. The names of its switches say what they do: a technique to
 * switch off, an attribute, or a method to call.
 */
export class LiveFigure {
  readonly #element: CandleFlameElement;
  readonly #window: HTMLElement;
  readonly #figure: HTMLElement;

  constructor(figure: HTMLElement) {
    const element = figure.querySelector("candle-flame");
    if (!element) throw new Error("The page's markup has a figure without a flame.");
    this.#element = element;
    this.#figure = figure;
    this.#window = find(figure, ".window", HTMLElement);
    for (const control of figure.querySelectorAll("[name]")) this.#bind(control);
    this.#moveCamera();
    element.addEventListener("load", () => this.#putDown());
    if (element.scene === "room") this.#watch();
  }

  #bind(control: Element): void {
    const element = this.#element;
    if (control instanceof HTMLButtonElement) {
      const method = control.name as "light" | "extinguish";
      control.addEventListener("click", () => element[method]());
    } else if (control instanceof HTMLInputElement && control.type === "checkbox") {
      const feature = control.name as Feature;
      control.addEventListener("change", () => {
        element.features[feature] = control.checked;
      });
    } else if (control instanceof HTMLInputElement || control instanceof HTMLSelectElement) {
      const output = control.parentElement?.querySelector("output");
      const show = () => {
        if (output) output.value = `${control.value} ${unitOf(control.name)}`;
      };
      control.addEventListener("input", () => {
        element.setAttribute(control.name, control.value);
        show();
      });
      show();
    }
  }

  /** To where the figure says; before the first frame already. */
  #moveCamera(): void {
    const camera = cameraOf(this.#figure.dataset.camera);
    if (camera) this.#element.camera = camera;
  }

  #putDown(): void {
    const from = cameraOf(this.#figure.dataset.place);
    if (from) {
      this.#element.camera = from;
      this.#element.place();
    }
    this.#moveCamera();
  }

  #watch(): void {
    const nearness = new IntersectionObserver(
      ([entry]) => {
        const isNear = entry?.isIntersecting ?? true;
        if (isNear === this.#element.isConnected) return;
        if (isNear) {
          this.#window.append(this.#element);
          this.#moveCamera();
        } else {
          this.#element.remove();
        }
      },
      { rootMargin: FAR },
    );
    nearness.observe(this.#figure);
  }
}

function unitOf(name: string): string {
  const setting = SETTINGS[name as keyof typeof SETTINGS];
  return setting.kind === "number" ? setting.unit : "";
}

/** x y z, yaw, pitch: metres and radians. */
function cameraOf(text: string | undefined): Camera | null {
  if (text === undefined) return null;
  const [x = 0, y = 0, z = 0, yaw = 0, pitch = 0] = text.split(" ").map(Number);
  return { position: [x, y, z], yaw, pitch };
}
