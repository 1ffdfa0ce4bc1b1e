/** Milliseconds that the browser has to restore a lost context before the visitor is asked to reload. */
const PATIENCE = 5000;

interface Reactions {
  readonly onLost: () => void;
  readonly onRestored: () => void;
  /** The wait was too long. The context may be restored all the same. */
  readonly onGivenUp: () => void;
}

/** Watches a canvas's WebGL context until the signal aborts: asks the browser to restore it if it is lost. */
export function watchContext(
  canvas: HTMLCanvasElement,
  signal: AbortSignal,
  { onLost, onRestored, onGivenUp }: Reactions,
): void {
  let patience = 0;
  const stopWaiting = () => clearTimeout(patience);
  const handleLoss = (event: Event): void => {
    event.preventDefault(); // asks the browser to restore it
    stopWaiting();
    patience = window.setTimeout(onGivenUp, PATIENCE);
    onLost();
  };
  const handleRestoration = (): void => {
    stopWaiting();
    onRestored();
  };
  canvas.addEventListener("webglcontextlost", handleLoss, { signal });
  canvas.addEventListener("webglcontextrestored", handleRestoration, { signal });
  signal.addEventListener("abort", stopWaiting);
}
