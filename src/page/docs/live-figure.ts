import type { Camera, CandleFlameElement, Feature } from "../../candle-flame-element.js";
import { SETTINGS } from "../../settings.js";
import { find } from "../find.js";

/** A room this many screens away is removed, and inserted again when it is near. */
const FAR = "150%";

/**
 * Binds a figure that the element itself draws. The names of its switches say what they do: a technique to
 * switch off, a candle to light by its number, an attribute, or a method to call.
 */
export function bindLiveFigure(figure: HTMLElement): void {
  const element = find(figure, "candle-flame", HTMLElement) as CandleFlameElement;
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
    ([entry]) => {
      const isNear = entry?.isIntersecting ?? true;
      if (isNear === element.isConnected) return;
      if (!isNear) return element.remove();
      window.append(element);
      moveCamera();
    },
    { rootMargin: FAR },
  );
  nearness.observe(figure);
}

function bindControl(element: CandleFlameElement, control: Element): void {
  if (control instanceof HTMLButtonElement) {
    const method = control.name as "light" | "extinguish";
    control.addEventListener("click", () => element[method]());
  } else if (control instanceof HTMLInputElement && control.type === "checkbox") {
    const [name, number] = control.name.split(" ");
    control.addEventListener("change", () => {
      if (name !== "candle") element.features[name as Feature] = control.checked;
      else if (control.checked) element.candles[Number(number)]?.light();
      else element.candles[Number(number)]?.extinguish();
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

function unitOf(name: string): string {
  const setting = SETTINGS[name as keyof typeof SETTINGS];
  return setting.kind === "number" ? setting.unit : "";
}

/** x y z, yaw, pitch: metres and radians. */
function cameraOf(text: string): Camera {
  const [x = 0, y = 0, z = 0, yaw = 0, pitch = 0] = text.split(" ").map(Number);
  return { position: [x, y, z], yaw, pitch };
}
