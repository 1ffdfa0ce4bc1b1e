import type { Page } from "playwright/test";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";

export const LIBRARY = "http://127.0.0.1:4174/";

/** Attributes of the element under test; `""` sets a flag. */
export type Attributes = Readonly<Record<string, string>>;

function html(attributes: Attributes, width: number, height: number): string {
  const list = Object.entries(attributes).map(([name, value]) => `${name}="${value}"`);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>test</title>
    <style>body { margin: 0; background: #000 } candle-flame { width: ${width}px; height: ${height}px; aspect-ratio: auto }</style>
    <candle-flame ${list.join(" ")}></candle-flame>
    <script type="module" src="/define.js"></script></html>`;
}

/**
 * A page with one element of the built package, and the verbs that a visitor of it would use.
 *
 * Nothing waits for time: the element is paused and stepped.
 */
export class RoomDriver {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  /** Opens the element, paused unless told otherwise, and waits for its first frame. */
  async open(
    attributes: Attributes = {},
    { width = 640, height = 360, paused = true } = {},
  ): Promise<this> {
    await this.load(attributes, { width, height, paused });
    await this.page
      .locator("candle-flame")
      .evaluate((element: CandleFlameElement) => element.ready);
    return this;
  }

  /** The same, without waiting: for elements that are to fail. */
  async load(
    attributes: Attributes = {},
    { width = 640, height = 360, paused = true } = {},
  ): Promise<this> {
    const body = html(paused ? { paused: "", ...attributes } : attributes, width, height);
    await this.page.route(`${LIBRARY}room.html`, (route) =>
      route.fulfill({ contentType: "text/html", body }),
    );
    await this.page.goto(`${LIBRARY}room.html`);
    await this.page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
    return this;
  }

  /** Runs a function on the element in the page. */
  evaluate<Result, Argument = undefined>(
    run: (element: CandleFlameElement, argument: Argument) => Result | Promise<Result>,
    argument?: Argument,
  ): Promise<Result> {
    // Playwright types the argument of `evaluate` as handles, which plain data never is.
    return this.page
      .locator("candle-flame")
      .evaluate(run as never, argument as never) as Promise<Result>;
  }

  step(seconds: number, times = 1): Promise<void> {
    return this.evaluate(
      (element, { seconds, times }) => {
        for (let i = 0; i < times; i++) element.step(seconds);
      },
      { seconds, times },
    );
  }

  /** A hash of the picture's pixels. */
  pixels(): Promise<string> {
    return this.evaluate(async (element) => {
      const bitmap = await createImageBitmap(await element.toBlob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      if (!context) throw new Error("no 2D canvas");
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const digest = await crypto.subtle.digest("SHA-256", data);
      return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    });
  }
}
