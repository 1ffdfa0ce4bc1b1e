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
  const lost = (event: Event): void => {
    event.preventDefault(); // asks the browser to restore it
    stopWaiting();
    patience = window.setTimeout(onGivenUp, PATIENCE);
    onLost();
  };
  const restored = (): void => {
    stopWaiting();
    onRestored();
  };
  canvas.addEventListener("webglcontextlost", lost, { signal });
  canvas.addEventListener("webglcontextrestored", restored, { signal });
  signal.addEventListener("abort", stopWaiting);
}
