/** Seconds in sight that the browser has to restore a lost context before the visitor is asked to reload. */
const PATIENCE = 5;

/** Watches a canvas's WebGL context until the signal aborts: asks the browser to restore it if it is lost. */
export function watchContext(
  canvas: HTMLCanvasElement,
  signal: AbortSignal,
  reactions: {
    readonly isVisible: () => boolean;
    readonly onLost: () => void;
    readonly onRestored: () => void;
    /** The wait was too long. The context may be restored all the same. */
    readonly onGivenUp: () => void;
  },
): void {
  let timer = 0;
  const stopWaiting = () => clearInterval(timer);
  const handleLoss = (event: Event): void => {
    event.preventDefault(); // asks the browser to restore it
    stopWaiting();
    let patience = PATIENCE;
    timer = window.setInterval(() => {
      if (!reactions.isVisible() || --patience) return;
      stopWaiting();
      reactions.onGivenUp();
    }, 1000);
    reactions.onLost();
  };
  canvas.addEventListener("webglcontextlost", handleLoss, { signal });
  canvas.addEventListener("webglcontextrestored", stopWaiting, { signal });
  canvas.addEventListener("webglcontextrestored", reactions.onRestored, { signal });
  signal.addEventListener("abort", stopWaiting);
}
