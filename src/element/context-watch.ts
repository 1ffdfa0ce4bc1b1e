import type { Lifecycle } from "./lifecycle.js";

/** Milliseconds that the browser has to restore a lost context before the visitor is asked to reload. */
const PATIENCE = 5000;

/**
 * Watches a canvas's WebGL context until the signal aborts: asks the browser to restore it if it is lost. It may still
 * be restored when that is given up.
 */
export function watchContext(
  canvas: HTMLCanvasElement,
  signal: AbortSignal,
  owner: Lifecycle,
  onRestored: () => void,
): void {
  let patience = 0;
  const stopWaiting = () => clearTimeout(patience);
  const handleLoss = (event: Event): void => {
    event.preventDefault(); // asks the browser to restore it
    stopWaiting();
    patience = window.setTimeout(() => owner.onContextGivenUp(), PATIENCE);
    owner.onContextLost();
  };
  canvas.addEventListener("webglcontextlost", handleLoss, { signal });
  canvas.addEventListener("webglcontextrestored", stopWaiting, { signal });
  canvas.addEventListener("webglcontextrestored", onRestored, { signal });
  signal.addEventListener("abort", stopWaiting);
}
