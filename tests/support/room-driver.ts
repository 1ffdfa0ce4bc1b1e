import { createHash } from "node:crypto";
import type { Page } from "playwright/test";
import sharp from "sharp";
import type {
  Camera,
  CandleFlameElement,
  Features,
  Look,
  Stats,
} from "../../src/candle-flame-element.ts";
import type { Inspection, Quality } from "../../src/settings.ts";
import { ORIGINS } from "./browser.ts";
import { serveSmallTextures } from "./small-textures.ts";

export const LIBRARY = ORIGINS.library;

/** Attributes of the element under test; `""` sets a flag. */
export type Attributes = Readonly<Record<string, string>>;

/** Unless a test says otherwise: a room that is quick to load and to draw, a pixel for a pixel, and no moon. */
const PAPER: Attributes = { look: "paper", quality: "medium", moonlight: "0" };

export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Buffer;
}

export interface Opening {
  /** CSS pixels of the element's box. Small ones are quick: every step draws. */
  readonly width?: number;
  readonly height?: number;
  readonly paused?: boolean;
  /** Whether the paper's looks have their own textures: else small grey ones, which are quick to load. */
  readonly hasTextures?: boolean;
  /** A .glb, in place of the room that the look has. */
  readonly model?: Buffer;
  /** More of the page, after the element. */
  readonly after?: string;
}

function html(attributes: Attributes, { width = 640, height = 360, after = "" }: Opening): string {
  const list = Object.entries(attributes).map(([name, value]) => `${name}="${value}"`);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>test</title>
    <style>body { margin: 0; background: #000 } candle-flame { width: ${width}px; height: ${height}px; aspect-ratio: auto }</style>
    <candle-flame ${list.join(" ")}></candle-flame>
    <script type="module" src="/define.js"></script>${after}</html>`;
}

/** What is done before a picture is taken, in this order and in one go: so it is drawn once. */
export interface Change {
  /** `null` takes one away. Where they name other models, these are awaited. */
  readonly attributes?: Readonly<Record<string, string | null>>;
  /** Time 0, as if new. */
  readonly isReset?: boolean;
  /** Where the visitor puts the candle down. */
  readonly place?: Camera | undefined;
  readonly camera?: Partial<Camera>;
  readonly features?: Partial<Features>;
  readonly inspect?: Inspection;
  /** Strength of a breath before the step, 0 to 1. */
  readonly breath?: number;
  /** As long is stepped. */
  readonly seconds?: number;
}

/** What the page complained of, as it happens: exceptions, rejections, console and WebGL errors. */
export function complaintsOf(page: Page): readonly string[] {
  const complaints: string[] = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => {
    // WebGL's own errors come as warnings; so does its advice on speed, which is none.
    const isError = message.type() === "error" || /INVALID_|OUT_OF_MEMORY/.test(message.text());
    if (isError) complaints.push(message.text());
  });
  return complaints;
}

/**
 * A page with one element of the built package, and the verbs that a visitor of it would use.
 *
 * Nothing waits for time: the element is paused and stepped.
 */
export class RoomDriver {
  readonly page: Page;
  readonly complaints: readonly string[];
  readonly #element: string;

  /** @param element selector; of several, the first is meant */
  constructor(page: Page, element = "candle-flame") {
    this.page = page;
    this.#element = element;
    this.complaints = complaintsOf(page);
  }

  /** Opens the element, paused unless told otherwise, and waits for its first frame. */
  async open(attributes: Attributes = {}, opening: Opening = {}): Promise<this> {
    await this.load(attributes, opening);
    await this.evaluate((element) => element.ready);
    return this;
  }

  /** The same, without waiting: for elements that are to fail. */
  async load(attributes: Attributes = {}, opening: Opening = {}): Promise<this> {
    const { paused = true, model, hasTextures = attributes.look === "physical" } = opening;
    // Routes of the page itself come first.
    if (!hasTextures) await serveSmallTextures(this.page.context());
    const src = `${LIBRARY}own-room.glb`;
    if (model) {
      await this.page.route(src, (route) =>
        route.fulfill({ contentType: "model/gltf-binary", body: model }),
      );
    }
    const given = { ...(paused ? { paused: "" } : {}), ...(model ? { src } : {}), ...attributes };
    const body = html({ ...PAPER, ...given }, opening);
    await this.page.route(`${LIBRARY}room.html`, (route) =>
      route.fulfill({ contentType: "text/html", body }),
    );
    await this.page.goto(`${LIBRARY}room.html`);
    await this.page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
    return this;
  }

  /** Brings an opened element back to how one opens, paused at time 0. Draws nothing: a test draws what it looks at. */
  async restore(look: Look = "paper", quality?: Quality): Promise<void> {
    await this.change(look);
    await this.evaluate((element, quality) => {
      const { requestAnimationFrame } = globalThis;
      globalThis.requestAnimationFrame = () => 0;
      element.blur();
      element.paused = true;
      if (quality) element.quality = quality;
      element.moonlight = 0;
      const kept = ["paused", "look", "quality", "moonlight"];
      for (const name of element.getAttributeNames()) {
        if (!kept.includes(name)) element.removeAttribute(name);
      }
      for (const name of Object.keys(element.features) as (keyof Features)[]) {
        element.features[name] = true;
      }
      element.reset();
      globalThis.requestAnimationFrame = requestAnimationFrame;
    }, quality);
  }

  /** Runs a function on the element in the page. */
  evaluate<Result, Argument = undefined>(
    run: (element: CandleFlameElement, argument: Argument) => Result | Promise<Result>,
    argument?: Argument,
  ): Promise<Result> {
    // Playwright types the argument of `evaluate` as handles, which plain data never is.
    return this.page
      .locator(this.#element)
      .first()
      .evaluate(run as never, argument as never) as Promise<Result>;
  }

  set(attributes: Attributes): Promise<void> {
    return this.evaluate((element, attributes) => {
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    }, attributes);
  }

  /** Changes to a look, and waits for its models where it has others. */
  change(look: Look): Promise<void> {
    return this.evaluate(async (element, look) => {
      const hasOtherModels = (element.look === "physical") !== (look === "physical");
      const loaded = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      element.look = look;
      if (hasOtherModels) await loaded;
    }, look);
  }

  switchFeatures(features: Partial<Features>): Promise<void> {
    return this.evaluate((element, features) => {
      for (const name of Object.keys(features) as (keyof Features)[]) {
        element.features[name] = features[name] ?? true;
      }
    }, features);
  }

  step(seconds: number, times = 1): Promise<void> {
    return this.evaluate(
      (element, { seconds, times }) => {
        for (let i = 0; i < times; i++) element.step(seconds);
      },
      { seconds, times },
    );
  }

  /** Stands somewhere, looks somewhere. */
  stand(camera: Partial<Camera>): Promise<void> {
    return this.evaluate((element, camera) => {
      element.camera = { ...element.camera, ...camera };
    }, camera);
  }

  camera(): Promise<Camera> {
    return this.evaluate((element) => element.camera);
  }

  stats(): Promise<Stats> {
    return this.evaluate((element) => element.stats);
  }

  isWalking(): Promise<boolean> {
    return this.evaluate((element) => element.matches(":state(walking)"));
  }

  /** The picture as a PNG file. */
  async png(change: Change = {}): Promise<Buffer> {
    const bytes = await this.evaluate(async (element, change) => {
      const {
        attributes = {},
        isReset,
        place,
        camera,
        features,
        inspect,
        breath,
        seconds,
      } = change;
      const modelsOf = () => `${element.look === "physical"} ${element.src}`;
      const before = modelsOf();
      const loaded = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      for (const [name, value] of Object.entries(attributes)) {
        if (value === null) element.removeAttribute(name);
        else element.setAttribute(name, value);
      }
      if (modelsOf() !== before) await loaded;
      if (isReset) element.reset();
      if (place) {
        element.camera = place;
        element.place();
      }
      if (camera) element.camera = { ...element.camera, ...camera };
      Object.assign(element.features, features);
      if (inspect) element.inspect = inspect;
      if (breath !== undefined) {
        element.step(0.5);
        element.blow(breath);
      }
      if (seconds !== undefined) element.step(seconds);
      return new Uint8Array(await (await element.toBlob()).arrayBuffer());
    }, change);
    return Buffer.from(bytes);
  }

  /** The picture's pixels, 8-bit RGBA, rows from the top. */
  async picture(change: Change = {}): Promise<Picture> {
    const { data, info } = await sharp(await this.png(change))
      .ensureAlpha()
      .raw()
      .toBuffer({ resolveWithObject: true });
    return { width: info.width, height: info.height, data };
  }

  /** A hash of the picture's pixels. */
  async pixels(change: Change = {}): Promise<string> {
    const { data } = await this.picture(change);
    return createHash("sha256").update(data).digest("hex");
  }
}
