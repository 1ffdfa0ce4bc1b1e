const waiting: (() => void)[] = [];
const channel = globalThis.MessageChannel ? new MessageChannel() : null;

/** Resolves in a task of its own, sooner than any timer: between two of them the page can answer its visitor. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    if (!channel) return resolve();
    waiting.push(resolve);
    channel.port1.onmessage = () => waiting.shift()?.();
    channel.port2.postMessage(null);
  });
}
