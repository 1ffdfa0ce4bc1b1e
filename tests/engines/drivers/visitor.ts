import { contextErrors } from "./recorder.ts";

/** One page of one browser, as its protocol drives it. */
export interface Driver {
  /** Name and version, as a reader knows them. */
  readonly version: string;
  /** What the browser itself reported of the page, in order. */
  readonly messages: readonly string[];
  goto(url: string): Promise<void>;
  /** The value of a JavaScript expression; a promise's is awaited. */
  evaluate(expression: string): Promise<unknown>;
  /** A key by its code: `KeyW`, `Enter`, `Escape`. */
  key(type: "down" | "up", code: string): Promise<void>;
  /** CSS pixels of the viewport. */
  move(x: number, y: number): Promise<void>;
  button(type: "down" | "up"): Promise<void>;
  close(): Promise<void>;
  /** Ends the browser's processes, which may answer nothing any more. */
  kill(): void;
}

/** The browser did not answer in time, and was ended. */
export class HungError extends Error {
  override readonly name = "HungError";
}

/** Seconds. */
const LIMITS = { open: 60, evaluate: 60, input: 30, close: 10 } as const;

/**
 * A visitor of pages in one browser: opens, evaluates, presses, drags, and hears what the page complains of.
 *
 * Each call has a limit. Past it the browser is ended and the call rejects with a `HungError`.
 */
export class Visitor {
  readonly #driver: Driver;
  /** Of the driver's messages, those of pages before. */
  #past = 0;

  constructor(driver: Driver) {
    this.#driver = driver;
  }

  get version(): string {
    return this.#driver.version;
  }

  async open(url: string): Promise<void> {
    this.#past = this.#driver.messages.length;
    await this.#within(LIMITS.open, "open", this.#driver.goto(url));
  }

  /** Runs a function in the page; it knows its arguments and the page's globals, nothing else. */
  async evaluate<Arguments extends readonly unknown[], Result>(
    run: (...args: Arguments) => Result | Promise<Result>,
    args: Arguments = [] as never,
    seconds: number = LIMITS.evaluate,
  ): Promise<Result> {
    const expression = `(${run})(...${JSON.stringify(args)})`;
    return this.#within(seconds, "evaluate", this.#driver.evaluate(expression)) as Promise<Result>;
  }

  /** Waits until a function of the page gives true, or throws. */
  async until<Arguments extends readonly unknown[]>(
    run: (...args: Arguments) => boolean,
    args: Arguments = [] as never,
    seconds = 10,
  ): Promise<void> {
    const end = performance.now() + seconds * 1000;
    while (!(await this.evaluate(run, args))) {
      if (performance.now() > end) throw new Error(`not within ${seconds} s: ${run}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  async press(code: string): Promise<void> {
    await this.keyDown(code);
    await this.keyUp(code);
  }

  keyDown(code: string): Promise<void> {
    return this.#within(LIMITS.input, `key ${code} down`, this.#driver.key("down", code));
  }

  keyUp(code: string): Promise<void> {
    return this.#within(LIMITS.input, `key ${code} up`, this.#driver.key("up", code));
  }

  move(x: number, y: number): Promise<void> {
    return this.#within(LIMITS.input, "mouse move", this.#driver.move(x, y));
  }

  async click(x: number, y: number): Promise<void> {
    await this.drag([x, y]);
  }

  /** Presses at the first point, goes to the others, lifts at the last. */
  async drag(...points: readonly (readonly [x: number, y: number])[]): Promise<void> {
    for (const [i, point] of points.entries()) {
      await this.move(...point);
      if (i === 0) await this.#within(LIMITS.input, "mouse down", this.#driver.button("down"));
    }
    await this.#within(LIMITS.input, "mouse up", this.#driver.button("up"));
  }

  /** Clicks the middle of the first element that a selector finds. */
  async clickOn(selector: string): Promise<void> {
    const [x, y] = await this.evaluate(
      (selector) => {
        const element = document.querySelector(selector);
        if (!element) throw new Error(`There is no ${selector}.`);
        element.scrollIntoView({ block: "nearest", behavior: "instant" });
        const { left, top, width, height } = element.getBoundingClientRect();
        return [left + width / 2, top + height / 2] as const;
      },
      [selector],
    );
    await this.click(Math.round(x), Math.round(y));
  }

  /** What the open page complained of so far, by its own record (`recorder.ts`) and the browser's. */
  async complaints(): Promise<readonly string[]> {
    const recorded = await this.evaluate(() => globalThis.complaints ?? null);
    if (!recorded) return ["error: nothing was recorded", ...this.reported];
    const errors = await this.evaluate(contextErrors);
    return [
      ...new Set([...recorded, ...errors.map((error) => `WebGL: ${error}`), ...this.reported]),
    ];
  }

  /** The browser's part of it, which a page that hangs cannot keep back. */
  get reported(): readonly string[] {
    return this.#driver.messages.slice(this.#past);
  }

  async close(): Promise<void> {
    await this.#within(LIMITS.close, "close", this.#driver.close()).catch(() => {});
    this.#driver.kill();
  }

  async #within<Result>(seconds: number, what: string, result: Promise<Result>): Promise<Result> {
    let timer: NodeJS.Timeout | undefined;
    const hung = new Promise<never>((_, reject) => {
      timer = setTimeout(() => {
        reject(new HungError(`${what}: no answer within ${seconds} s`));
        this.#driver.kill();
      }, seconds * 1000);
    });
    try {
      return await Promise.race([result, hung]);
    } finally {
      clearTimeout(timer);
    }
  }
}
