import type { ChildProcess } from "node:child_process";
import { freePorts } from "../../../tools/free-ports.mjs";
import { environment, killGroup, type Launch, spawnGroup } from "./paged-driver.ts";
import type { Driver } from "./visitor.ts";

/** What the protocol calls keys that type nothing. */
const KEYS: Readonly<Record<string, string>> = { Enter: "\uE007", Escape: "\uE00C" };
/** Milliseconds; a visitor's limits are shorter. */
const LONG = 600_000;
/** How often a driver is asked whether it listens, and how long between, milliseconds. */
const ASKING = { times: 100, pause: 100 } as const;

/** What a page's function came to, as JSON. */
type Outcome = { readonly value?: unknown; readonly error?: string };

/** WebKitGTK's MiniBrowser by WebKitWebDriver: W3C WebDriver over HTTP. */
export class WebKitDriver implements Driver {
  /** Its automation tells nothing of the console; the page's own record does. */
  readonly messages: readonly string[] = [];
  readonly #driver: ChildProcess;
  readonly #session: string;
  readonly version: string;

  /** @param browser the path of a MiniBrowser */
  static async launch({ path, env = {} }: Launch, browser: string): Promise<WebKitDriver> {
    const [port] = await freePorts(1);
    const driver = spawnGroup(path, [`--port=${port}`], {
      env: environment({ ...env, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1" }),
      stdio: "ignore",
    });
    try {
      const origin = `http://127.0.0.1:${port}`;
      await listening(origin, driver);
      const options = { binary: browser, args: ["--automation"] };
      const alwaysMatch = { browserName: "MiniBrowser", "webkitgtk:browserOptions": options };
      const { sessionId, capabilities } = (await call("POST", `${origin}/session`, {
        capabilities: { alwaysMatch },
      })) as { sessionId: string; capabilities: { browserVersion: string } };
      const session = `${origin}/session/${sessionId}`;
      await call("POST", `${session}/timeouts`, { script: LONG, pageLoad: LONG });
      return new WebKitDriver(driver, session, `WebKitGTK ${capabilities.browserVersion}`);
    } catch (error) {
      if (driver.pid) killGroup(driver.pid);
      throw error;
    }
  }

  private constructor(driver: ChildProcess, session: string, version: string) {
    this.#driver = driver;
    this.#session = session;
    this.version = version;
  }

  async goto(url: string): Promise<void> {
    await this.#ask("url", { url });
  }

  async evaluate(expression: string): Promise<unknown> {
    const script = `const done = arguments[0];
      (async () => ${expression})().then((value) => done({ value }), (error) => done({ error: String(error) }));`;
    const { value, error } = (await this.#ask("execute/async", { script, args: [] })) as Outcome;
    if (error) throw new Error(error);
    return value;
  }

  key(type: "down" | "up", code: string): Promise<void> {
    const value = KEYS[code] ?? code.replace(/^Key/, "").toLowerCase();
    return this.#act("key", { type: type === "down" ? "keyDown" : "keyUp", value });
  }

  move(x: number, y: number): Promise<void> {
    return this.#act("pointer", { type: "pointerMove", duration: 0, x, y, origin: "viewport" });
  }

  button(type: "down" | "up"): Promise<void> {
    return this.#act("pointer", { type: type === "down" ? "pointerDown" : "pointerUp", button: 0 });
  }

  async close(): Promise<void> {
    await call("DELETE", this.#session);
  }

  kill(): void {
    if (this.#driver.pid) killGroup(this.#driver.pid);
  }

  async #act(type: "key" | "pointer", action: object): Promise<void> {
    const parameters = type === "pointer" ? { parameters: { pointerType: "mouse" } } : {};
    await this.#ask("actions", { actions: [{ type, id: type, ...parameters, actions: [action] }] });
  }

  #ask(path: string, body: object): Promise<unknown> {
    return call("POST", `${this.#session}/${path}`, body);
  }
}

async function call(method: string, url: string, body?: object): Promise<unknown> {
  const response = await fetch(url, {
    method,
    ...(body ? { body: JSON.stringify(body) } : {}),
    headers: { "content-type": "application/json" },
    signal: AbortSignal.timeout(LONG),
  });
  const { value } = (await response.json()) as {
    value: { error?: string; message?: string } | null;
  };
  if (!response.ok) throw new Error(`${value?.error}: ${value?.message}`);
  return value;
}

async function listening(origin: string, driver: ChildProcess): Promise<void> {
  for (let i = 0; i < ASKING.times && driver.exitCode === null; i++) {
    const isUp = await call("GET", `${origin}/status`).then(
      () => true,
      () => false,
    );
    if (isUp) return;
    await new Promise((resolve) => setTimeout(resolve, ASKING.pause));
  }
  throw new Error("WebKitWebDriver does not listen.");
}
