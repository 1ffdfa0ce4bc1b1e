import { windowOf } from "../window-of.js";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Device pixels of an element's content box, near enough where the browser does not report them. */
export function guessDevicePixels(element: Element): Size {
  const { clientWidth, clientHeight } = element;
  const ratio = windowOf(element).devicePixelRatio * zoomOf(element);
  return { width: Math.round(clientWidth * ratio), height: Math.round(clientHeight * ratio) };
}

/** The page's `zoom` of an element, by which its box has more pixels; older browsers do not tell. */
const zoomOf = (element: Element): number => element.currentCSSZoom ?? 1;

/**
 * Observes an element's content box in device pixels, to the pixel: now, and whenever the element, the
 * zoom or the monitor changes.
 *
 * A canvas of any other size would be resampled. Safari has no `device-pixel-content-box`; there it is
 * a guess, which is off by a pixel where a box lies between pixels.
 */
export function observeDevicePixels(
  element: Element,
  signal: AbortSignal,
  onChange: (size: Size) => void,
): void {
  const view = windowOf(element);
  let exact: Size | null = null;
  const report = () => onChange(exact ?? guessDevicePixels(element));
  const observer = new view.ResizeObserver((entries) => {
    const box = entries.at(-1)?.devicePixelContentBoxSize?.[0];
    const reported = box && { width: box.inlineSize, height: box.blockSize };
    exact = reported && !isEmulated(reported, element) ? reported : null;
    report();
  });
  try {
    observer.observe(element, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(element);
  }
  signal.addEventListener("abort", () => observer.disconnect());
  // On a monitor of another density the same box may have as many pixels as before.
  const awaitRatio = (): void => {
    const query = view.matchMedia(`(resolution: ${view.devicePixelRatio}dppx)`);
    const handleChange = (): void => {
      report();
      awaitRatio();
    };
    query.addEventListener("change", handleChange, { once: true, signal });
  };
  awaitRatio();
}

/** Chromium 156 reports CSS pixels where a tool emulates a monitor of another density (DevTools, test runners). */
function isEmulated(reported: Size, element: Element): boolean {
  if (windowOf(element).devicePixelRatio === 1) return false;
  const { clientWidth, clientHeight } = element;
  const zoom = zoomOf(element);
  const isNear = (pixels: number, length: number) =>
    Math.abs(pixels - length * zoom) <= Math.max(1, zoom);
  return isNear(reported.width, clientWidth) && isNear(reported.height, clientHeight);
}
