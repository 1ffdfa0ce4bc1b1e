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
