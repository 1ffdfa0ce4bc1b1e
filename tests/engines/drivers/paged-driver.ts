import { type SpawnOptions, spawn } from "node:child_process";
import {
  type BrowserServer,
  chromium,
  firefox,
  type Browser as OfPlaywright,
  webkit,
} from "playwright";
import puppeteer, { type Browser as OfPuppeteer } from "puppeteer-core";
import type { Driver } from "./visitor.ts";

/** CSS pixels. */
const VIEWPORT = { width: 800, height: 520 } as const;
/** Its own limits are longer than a visitor's, who ends the browser. */
const LONG = 600_000;

export interface Launch {
  readonly path: string;
  readonly args?: readonly string[];
  readonly env?: Readonly<Record<string, string | undefined>>;
}

/** Firefox draws WebGL by software only if told to; and writes to its error output what its console has. */
const FIREFOX = { "webgl.force-enabled": true, "browser.dom.window.dump.enabled": true } as const;
/** In that output, what concerns a page; WebGL's warnings come from nowhere. */
const WARNING = /^JavaScript (warning|error): (?:http[^\s,]*)?, line \d+: (.*)$/gm;

const PLAYWRIGHT = { chromium, firefox, webkit } as const;

/** What Playwright's pages and Puppeteer's have in common. */
interface Page {
  goto(url: string, options: { timeout: number }): Promise<unknown>;
  evaluate(expression: string): Promise<unknown>;
  readonly keyboard: {
    down(code: never): Promise<void>;
    up(code: never): Promise<void>;
  };
  readonly mouse: {
    move(x: number, y: number): Promise<void>;
    down(): Promise<void>;
    up(): Promise<void>;
  };
}

interface Message {
  type(): string;
  text(): string;
}

const LEVELS: Readonly<Record<string, string>> = { warning: "warn" };

/** A driver of a page that listens to it. */
class PagedDriver implements Driver {
  readonly version: string;
  readonly messages: string[] = [];
  readonly close: () => Promise<void>;
  readonly kill: () => void;
  readonly #page: Page;

  constructor(page: Page, version: string, close: () => Promise<void>, kill: () => void) {
    this.#page = page;
    this.version = version;
    this.close = close;
    this.kill = kill;
  }

  readonly hear = (message: Message): void => {
    const level = message.type();
    this.messages.push(`${LEVELS[level] ?? level}: ${message.text()}`);
  };

  readonly hearError = (error: unknown): void => {
    this.messages.push(`exception: ${error instanceof Error ? error.message : String(error)}`);
  };

  async goto(url: string): Promise<void> {
    await this.#page.goto(url, { timeout: LONG });
  }

  evaluate(expression: string): Promise<unknown> {
    return this.#page.evaluate(expression);
  }

  key(type: "down" | "up", code: string): Promise<void> {
    return this.#page.keyboard[type](code as never);
  }

  move(x: number, y: number): Promise<void> {
    return this.#page.mouse.move(x, y);
  }

  button(type: "down" | "up"): Promise<void> {
    return this.#page.mouse[type]();
  }
}

const TITLES = { chromium: "Chromium", firefox: "Firefox", webkit: "WebKit" } as const;

/** A browser by Playwright: any Chromium, or its own builds of Firefox and WebKit. */
export async function launchByPlaywright(
  engine: keyof typeof PLAYWRIGHT,
  { path, args = [], env = {} }: Launch,
): Promise<Driver> {
  const server: BrowserServer = await PLAYWRIGHT[engine].launchServer({
    executablePath: path,
    args: [...args],
    env: environment(env),
    // A browser's window on a virtual display has WebGL where a headless one has none.
    headless: engine === "chromium" || !env.DISPLAY,
    ...(engine === "firefox" ? { firefoxUserPrefs: FIREFOX } : {}),
  });
  const browser: OfPlaywright = await PLAYWRIGHT[engine].connect(server.wsEndpoint());
  const context = await browser.newContext({ viewport: VIEWPORT, deviceScaleFactor: 1 });
  context.setDefaultTimeout(LONG);
  const page = await context.newPage();
  const driver = new PagedDriver(
    page as Page,
    `${TITLES[engine]} ${browser.version()}`,
    () => server.close(),
    () => void server.kill(),
  );
  page.on("console", driver.hear);
  page.on("pageerror", driver.hearError);
  return driver;
}

/** Firefox as a distribution has it, by WebDriver BiDi, which needs no driver of its own. */
export async function launchFirefox({ path, env = {} }: Launch): Promise<Driver> {
  const browser: OfPuppeteer = await puppeteer.launch({
    browser: "firefox",
    executablePath: path,
    headless: false,
    env: environment(env),
    defaultViewport: { ...VIEWPORT, deviceScaleFactor: 1 },
    extraPrefsFirefox: { ...FIREFOX },
    protocolTimeout: LONG,
  });
  const page = await browser.newPage();
  const version = (await browser.version()).replace(/^firefox\//i, "");
  const driver = new PagedDriver(
    page as unknown as Page,
    `Firefox ${version}`,
    () => browser.close(),
    () => {
      const { pid } = browser.process() ?? {};
      if (pid) killGroup(pid);
    },
  );
  page.on("console", driver.hear);
  page.on("pageerror", driver.hearError);
  // Its protocol leaves out the warnings of WebGL.
  browser.process()?.stderr?.on("data", (output) => {
    for (const [, level = "", text] of String(output).matchAll(WARNING)) {
      driver.messages.push(`${LEVELS[level] ?? level}: ${text}`);
    }
  });
  return driver;
}

/** Leaders of groups that are to end with this process, which an interrupt may. */
const groups = new Set<number>();
process.once("exit", () => groups.forEach(killGroup));

/** Starts a process that leads a group of its own. */
export function spawnGroup(path: string, args: readonly string[], options: SpawnOptions) {
  const child = spawn(path, args, { ...options, detached: true });
  if (child.pid) groups.add(child.pid);
  return child;
}

/** Ends a process that was started as the leader of its group, and all of that group. */
export function killGroup(pid: number): void {
  groups.delete(pid);
  try {
    process.kill(-pid, "SIGKILL");
  } catch {
    // It has ended by itself.
  }
}

/** This process's environment with others' values. */
export function environment(env: Launch["env"]): Record<string, string> {
  const all = Object.entries({ ...process.env, ...env });
  return Object.fromEntries(all.filter((entry): entry is [string, string] => Boolean(entry[1])));
}
