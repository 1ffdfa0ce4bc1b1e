import type { Camera, CandleFlameElement, Feature } from "../../candle-flame-element.js";
import { parseIndices, SETTINGS } from "../../settings.js";
import { find } from "../find.js";
import { showValue } from "../show-value.js";

/** A room this many screens away is removed, and inserted again when it is near. */
const FAR = "150%";

/**
 * Binds a figure that the element itself draws. The names of its switches say what they do: a technique to
 * switch off, a candle to light by its number, an attribute, or a method to call.
 */
export function bindLiveFigure(figure: HTMLElement): void {
  const element = find(figure, "candle-flame", HTMLElement) as CandleFlameElement;
  addSentence(element);
  const { camera, place } = figure.dataset;
  const moveCamera = () => {
    if (camera) element.camera = cameraOf(camera);
  };
  for (const control of figure.querySelectorAll("[name]")) bindControl(element, control);
  moveCamera();
  element.addEventListener("load", () => {
    if (place) {
      element.camera = cameraOf(place);
      element.place();
    }
    moveCamera();
  });
  if (element.scene !== "room") return;
  const window = find(figure, ".window", HTMLElement);
  const nearness = new IntersectionObserver(
    (entries) => {
      const isNear = entries.at(-1)?.isIntersecting ?? true;
      if (isNear === element.isConnected) return;
      if (!isNear) return element.remove();
      window.append(element);
      moveCamera();
    },
    { rootMargin: FAR },
  );
  nearness.observe(figure);
}

/** Until its first frame, which may take long without a GPU, the element shows that there will be one. */
function addSentence(element: CandleFlameElement): void {
  const sentence = document.createElement("p");
  sentence.slot = "poster";
  sentence.textContent = "The figure is being prepared…";
  element.append(sentence);
  element.addEventListener("error", () => sentence.remove());
  // A poster that is tried takes its place.
  element.addEventListener("progress", () => {
    if (element.poster) sentence.remove();
    else element.append(sentence);
  });
}

/** The element follows the control from now on, and what a reload has left in it. */
function bindControl(element: CandleFlameElement, control: Element): void {
  if (control instanceof HTMLButtonElement) {
    const method = control.name as "blow" | "extinguish" | "light" | "pause" | "play" | "reset";
    control.addEventListener("click", () => element[method]());
  } else if (control instanceof HTMLInputElement && control.type === "checkbox") {
    const [name, number] = control.name.split(" ");
    const act = () => {
      if (name === "candle") chooseCandle(element, Number(number), control.checked);
      else element.features[name as Feature] = control.checked;
    };
    control.addEventListener("change", act);
    act();
  } else if (control instanceof HTMLInputElement || control instanceof HTMLSelectElement) {
    const output = control.parentElement?.querySelector("output");
    const act = () => {
      element.setAttribute(control.name, control.value);
      if (output) showValue(control, output, `${control.value} ${unitOf(control.name)}`.trim());
    };
    control.addEventListener("input", act);
    act();
  }
}

/** Lights a candle or puts it out, by attributes: they last while there is no room. */
function chooseCandle(element: CandleFlameElement, index: number, isLit: boolean): void {
  const lit = new Set(element.unlit ? [] : parseIndices(element.litWicks));
  if (isLit) lit.add(index);
  else lit.delete(index);
  // Without a number it would be the carried one that burns.
  if (lit.size > 0) element.litWicks = [...lit].sort().join(" ");
  element.unlit = lit.size === 0;
}

function unitOf(name: string): string {
  const setting = SETTINGS[name as keyof typeof SETTINGS];
  return setting.kind === "number" ? setting.unit : "";
}

/** x y z, yaw, pitch: metres and radians. */
function cameraOf(text: string): Camera {
  const [x = 0, y = 0, z = 0, yaw = 0, pitch = 0] = text.split(" ").map(Number);
  return { position: [x, y, z], yaw, pitch };
}
