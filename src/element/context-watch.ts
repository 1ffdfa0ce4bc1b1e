/** How long the browser has to give a lost context back before the visitor is asked, in milliseconds. */
const PATIENCE = 5000;

interface Reactions {
  readonly onLost: () => void;
  readonly onRestored: () => void;
  /** It has been away for too long. It may come back all the same. */
  readonly onGivenUp: () => void;
}

/** Watches over a canvas's WebGL context until the signal aborts: asks for it again if it is lost, and waits. */
export function watchContext(
  canvas: HTMLCanvasElement,
  signal: AbortSignal,
  { onLost, onRestored, onGivenUp }: Reactions,
): void {
  let patience = 0;
  const stopWaiting = () => clearTimeout(patience);
  const lost = (event: Event): void => {
    event.preventDefault(); // asks the browser to give it back
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
