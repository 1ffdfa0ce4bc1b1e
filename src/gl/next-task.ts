const waiting: (() => void)[] = [];
let channel: MessageChannel | undefined;

/** Resolves in a new task, sooner than any timer: the page handles input between tasks. */
export function nextTask(): Promise<void> {
  channel ??= new MessageChannel();
  const { port1, port2 } = channel;
  port1.onmessage = () => waiting.shift()?.();
  return new Promise((resolve) => {
    waiting.push(resolve);
    port2.postMessage(null);
  });
}

/**
 * Resolves in a later task, after a pause of 1 ms that leaves the processor to others, software renderers among them;
 * without one where the browser has none but timers, which pause for longer.
 */
export function laterTask(): Promise<unknown> {
  // A page may have a `scheduler` of its own.
  return globalThis.scheduler?.postTask?.(() => {}, { delay: 1 }) ?? nextTask();
}
