const waiting: (() => void)[] = [];
const channel = globalThis.MessageChannel ? new MessageChannel() : null;

/** Resolves in a new task, sooner than any timer: the page handles input between tasks. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    if (!channel) return resolve();
    waiting.push(resolve);
    channel.port1.onmessage = () => waiting.shift()?.();
    channel.port2.postMessage(null);
  });
}

/** Milliseconds between two questions whether something has ended. */
const PAUSE = 2;

/**
 * Resolves in a later task, after a pause that leaves the processor to others, software renderers among them; without
 * one where the browser has none but timers, which pause for longer.
 */
export function laterTask(): Promise<unknown> {
  return globalThis.scheduler?.postTask(() => {}, { delay: PAUSE }) ?? nextTask();
}
