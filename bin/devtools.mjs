// A browser by its DevTools protocol, through a pipe: all of it that a poster needs, and no package.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const FLAGS = [
  "--headless",
  "--remote-debugging-pipe",
  "--no-first-run",
  "--no-default-browser-check",
  "--hide-scrollbars",
  "--force-color-profile=srgb",
  // On the CPU: the same picture on every machine.
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist",
  // In a container.
  "--disable-dev-shm-usage",
  ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
];

/** What ends the process before its time: Ctrl-C, or a system that shuts down. */
const SIGNALS = ["SIGINT", "SIGTERM"];

/** @param patience for any answer, milliseconds */
export async function openBrowser(path, patience) {
  const profile = mkdtempSync(join(tmpdir(), "candle-flame-"));
  const child = spawn(path, [...FLAGS, `--user-data-dir=${profile}`, "about:blank"], {
    stdio: ["ignore", "ignore", "pipe", "pipe", "pipe"],
  });
  const [, , errors, toBrowser, fromBrowser] = child.stdio;
  const waiting = new Map();
  let said = "";
  let count = 0;
  errors.setEncoding("utf8").on("data", (text) => {
    said = (said + text).slice(-2000);
  });
  const ended = new Promise((resolve) => {
    const end = (reason) => {
      for (const { reject } of waiting.values()) reject(new Error(`${path}: ${reason}\n${said}`));
      waiting.clear();
      resolve();
    };
    child.on("error", (error) => end(error.message));
    child.on("close", (code) => end(`the browser ended with ${code}.`));
  });
  const clean = () => {
    try {
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    } catch {
      // A browser that has just ended may hold its files: the system empties the folder.
    }
  };
  const interrupt = () => {
    child.kill();
    void ended.then(clean).then(() => process.exit(130));
  };
  for (const signal of SIGNALS) process.once(signal, interrupt);
  toBrowser.on("error", () => {}); // that it ended is said once
  let rest = "";
  fromBrowser.setEncoding("utf8").on("data", (text) => {
    const messages = (rest + text).split("\0");
    rest = messages.pop();
    for (const message of messages) {
      const { id, result, error } = JSON.parse(message);
      const call = waiting.get(id);
      waiting.delete(id);
      if (error) call?.reject(new Error(error.message));
      else call?.resolve(result);
    }
  });
  const send = (method, params = {}, sessionId = undefined) =>
    new Promise((resolve, reject) => {
      const id = ++count;
      const timer = setTimeout(() => reject(new Error(`${method} took too long.`)), patience);
      const settle = (how) => (value) => {
        clearTimeout(timer);
        how(value);
      };
      waiting.set(id, { resolve: settle(resolve), reject: settle(reject) });
      const hasEnded = child.exitCode !== null || child.signalCode !== null;
      if (hasEnded) waiting.get(id).reject(new Error(`${path} has ended.\n${said}`));
      else toBrowser.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });

  return {
    async openPage(url, { width, height }) {
      const { targetId } = await send("Target.createTarget", { url: "about:blank" });
      const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
      const ask = (method, params) => send(method, params, sessionId);
      const metrics = { width, height, deviceScaleFactor: 1, mobile: false };
      await ask("Emulation.setDeviceMetricsOverride", metrics);
      const { errorText } = await ask("Page.navigate", { url });
      if (errorText) throw new Error(`${url}: ${errorText}`);
      return {
        /** Runs a function that refers to nothing around it. */
        async evaluate(run, argument) {
          const expression = `(${run})(${JSON.stringify(argument)})`;
          const how = { expression, awaitPromise: true, returnByValue: true };
          const { result, exceptionDetails } = await ask("Runtime.evaluate", how);
          if (!exceptionDetails) return result.value;
          const { exception, text } = exceptionDetails;
          const [message] = (exception?.description ?? text).split("\n");
          throw new Error(message.replace(/^Error: /, ""));
        },
      };
    },
    async close() {
      child.kill();
      await ended;
      clean();
      for (const signal of SIGNALS) process.off(signal, interrupt);
    },
  };
}
