import type { Page } from "playwright/test";
import sharp from "sharp";
import { chromaticity, luma, type Rgb } from "../../src/light/color.ts";
import { type Drive, drawFrames, driveFrames } from "../support/driven-frames.ts";
import { drawOneSample } from "../support/one-sample.ts";
import { QUICK_ROOM } from "../support/plain-room.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const SPAWN = { position: [-1.55, 1.6, 1.3], yaw: -0.3 * Math.PI, pitch: -0.08 } as const;
const NIGHT = { look: "physical", quality: "low", seed: "1", moonlight: "0.15" } as const;

function linear(code: number): number {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** Linear light of a picture's pixels, where white is 1, from those of its parts. */
class Shown {
  readonly #pixels: readonly Rgb[];
  readonly #width: number;
  readonly #height: number;

  constructor(pixels: readonly Rgb[], width: number, height: number) {
    this.#pixels = pixels;
    this.#width = width;
    this.#height = height;
  }

  static async of(png: Buffer): Promise<Shown> {
    const { data, info } = await sharp(png)
      .removeAlpha()
      .raw()
      .toBuffer({ resolveWithObject: true });
    const { width, height } = info;
    const pixels = Array.from({ length: width * height }, (_, i): Rgb => {
      return [linear(data[3 * i]!), linear(data[3 * i + 1]!), linear(data[3 * i + 2]!)];
    });
    return new Shown(pixels, width, height);
  }

  /** Of a box, in shares of the picture's width and height. */
  part(left: number, top: number, right: number, bottom: number): Shown {
    const isIn = (i: number) => {
      const x = ((i % this.#width) + 0.5) / this.#width;
      const y = (Math.floor(i / this.#width) + 0.5) / this.#height;
      return x > left && x < right && y > top && y < bottom;
    };
    return new Shown(
      this.#pixels.filter((_, i) => isIn(i)),
      this.#width,
      this.#height,
    );
  }

  /** Luminance that a share of the pixels does not exceed. */
  quantile(share: number): number {
    const sorted = this.#pixels.map(luma).toSorted((a, b) => a - b);
    return sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
  }

  /** Share of blue in the light. */
  get blueness(): number {
    const sum = (i: 0 | 1 | 2) => this.#pixels.reduce((total, pixel) => total + pixel[i], 0);
    return sum(2) / (sum(0) + sum(1) + sum(2));
  }

  /** Deviation of the hues in u'v', of what is neither black nor white. */
  get hueSpread(): number {
    const hues = this.#pixels
      .filter((pixel) => luma(pixel) > 0.003 && luma(pixel) < 0.9)
      .map(chromaticity);
    const variance = (i: 0 | 1) => {
      const mean = hues.reduce((sum, hue) => sum + hue[i], 0) / hues.length;
      return hues.reduce((sum, hue) => sum + (hue[i] - mean) ** 2, 0) / hues.length;
    };
    return Math.sqrt(variance(0) + variance(1));
  }
}

const WINDOW = [0.56, 0.35, 0.61, 0.42] as const;
const CROSS = [0.25, 0.9, 0.4, 1] as const;
const WALL = [0.72, 0.2, 0.98, 0.6] as const;

test.describe("The night of the cabin", () => {
  let page: Page;
  let room: RoomDriver;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    await drawOneSample(page);
    room = await new RoomDriver(page).open(NIGHT, { width: 480, height: 270 });
  });
  test.afterEach(() => expect(room.complaints).toEqual([]));
  test.afterAll(() => page.close());

  test("comes in twenty seconds: black, the window, the floor, at last the room", async () => {
    await room.evaluate((element, camera) => {
      element.camera = camera;
      element.step(0.5);
      element.extinguish();
    }, SPAWN);
    const strip: Shown[] = [];
    for (const seconds of [1, 3, 5, 5, 6]) {
      strip.push(await Shown.of(await room.png({ seconds })));
    }
    const medians = strip.map((picture) => picture.part(...WALL).quantile(0.5));
    expect(medians[0], "at first the wall is black").toBeLessThan(0.001);
    for (const [i, median] of medians.slice(1).entries()) {
      expect(median, `after step ${i + 1}`).toBeGreaterThanOrEqual(medians[i]!);
    }
    const early = strip[1]!;
    expect(early.part(...WINDOW).quantile(0.8), "the window comes first").toBeGreaterThan(0.01);
    expect(early.part(...CROSS).quantile(0.95), "then what the moon shines on").toBeGreaterThan(
      0.005,
    );
    expect(early.quantile(0.5), "and the room is still dark").toBeLessThan(0.003);
    const end = strip.at(-1)!;
    expect(end.quantile(0.5)).toBeGreaterThan(0.01);
    expect(end.quantile(0.5)).toBeLessThan(0.03);
    expect(end.part(...CROSS).quantile(0.999), "the cross").toBeLessThan(0.25);
    expect(end.part(...CROSS).quantile(0.999), "the cross").toBeGreaterThan(0.1);
    // It pales as rods take over.
    expect(end.part(...CROSS).blueness).toBeLessThan(early.part(...CROSS).blueness);
  });

  test("gives way to a flame in seconds", async () => {
    await room.evaluate((element) => {
      element.unlit = true;
      element.reset();
      element.light();
    });
    const lit = await Shown.of(await room.png({ camera: SPAWN, seconds: 6 }));
    await room.evaluate((element) => {
      element.reset();
      element.light();
    });
    const settled = await Shown.of(await room.png({ camera: SPAWN, seconds: 12 }));
    expect(lit.quantile(0.5)).toBeGreaterThan(0.02);
    expect(Math.abs(lit.quantile(0.5) / settled.quantile(0.5) - 1)).toBeLessThan(0.1);
    await room.evaluate((element) => {
      element.unlit = false;
    });
  });

  test("lies cool beside the candle's gold", async () => {
    const box = { width: "1280px", height: "720px" };
    await room.evaluate((element, box) => void Object.assign(element.style, box), box);
    await expect.poll(async () => (await room.stats()).width).toBe(853);
    const change = { isReset: true, camera: SPAWN, seconds: 0.5 };
    const moonlit = await Shown.of(await room.png(change));
    const moonless = await Shown.of(await room.png({ attributes: { moonlight: "0" } }));
    expect(moonlit.hueSpread).toBeGreaterThan(0.02);
    expect(moonlit.part(...WINDOW).blueness).toBeGreaterThan(
      moonless.part(...WINDOW).blueness + 0.1,
    );
  });
});

test.describe("The night", () => {
  test("does not enter a room without openings", async ({ page }) => {
    const room = await new RoomDriver(page).open(
      { ...NIGHT, unlit: "", "moon-direction": "-70 35" },
      { width: 160, height: 90, model: QUICK_ROOM },
    );
    for (const yaw of [0, 1.6, 3.1, 4.7]) {
      const camera = { position: [0, 1.5, 0], yaw, pitch: -0.2 } as const;
      const shown = await Shown.of(await room.png({ camera, seconds: 0.1 }));
      expect(shown.quantile(1), `dither alone, at ${yaw}`).toBeLessThan(linear(2));
    }
  });

  test("does not enter it in a refined image, nor does the light of the flame that is out", async ({
    page,
  }) => {
    await driveFrames(page);
    const size = { width: 160, height: 90 };
    const room = await new RoomDriver(page).open(
      { ...NIGHT, quality: "auto", unlit: "", "moon-direction": "-70 35" },
      { ...size, model: QUICK_ROOM },
    );
    await room.evaluate((element) => {
      element.camera = { position: [0, 1.5, 0], yaw: 0, pitch: -0.2 };
      (Reflect.get(window, "drive") as Drive).isOn = true;
      element.play();
    });
    let tiles = 0;
    for (let frames = 0; tiles < 6; frames++) {
      expect(frames, "it is refined").toBeLessThan(2000);
      tiles += (await drawFrames(room, 1, 50))[0]!;
    }
    await drawFrames(room, 20, 50); // first draws to a target of the size are counted, too
    expect((await room.stats()).width).toBe(size.width);
    const shown = await Shown.of(await room.png());
    expect(shown.quantile(1), "dither alone").toBeLessThan(linear(2));
  });

  test("follows the moon in a running animation, after frames in which a part is prepared", async ({
    cabin: room,
  }) => {
    await room.set({ ...NIGHT, unlit: "", particles: "0" });
    await room.evaluate((element) => element.reset());
    const { before, frames, after, exact, shadowless } = await room.evaluate((element, camera) => {
      const light = () => element.readRadiance(0, 0, 160, 90).reduce((sum, x) => sum + x, 0);
      const stepTo = (direction: string) => {
        element.moonDirection = direction;
        element.step(0);
        return light();
      };
      element.camera = camera;
      element.step(1);
      const before = stepTo("-98 27");
      element.play();
      // The loop's own frames come between tasks: all of this is one.
      const frames = Array.from({ length: 60 }, () => stepTo("-98 40"));
      element.pause();
      const after = stepTo("-98 40");
      stepTo("-98 30");
      const exact = stepTo("-98 40");
      element.features.shadows = false;
      element.step(0);
      const shadowless = light();
      element.features.shadows = true;
      return { before, frames, after, exact, shadowless };
    }, SPAWN);
    expect(Math.abs(exact / before - 1), "another light").toBeGreaterThan(0.02);
    expect(frames.slice(0, 10).every((sum) => Math.abs(sum / before - 1) < 1e-3)).toBe(true);
    expect(Math.abs(frames.at(-1)! / exact - 1)).toBeLessThan(0.02);
    expect(after).toBeCloseTo(exact, 6);
    console.log(`without shadows ${(shadowless / exact).toFixed(2)} times the light`);
    expect(shadowless / exact, "its beam alone, also without shadows").toBeLessThan(2);
  });

  test("is nothing to the paper's look", async ({ room }) => {
    const before = await room.pixels({ isReset: true, seconds: 0.1 });
    await room.set({ moonlight: "0.3" });
    expect(await room.pixels({ isReset: true, seconds: 0.1 })).toBe(before);
  });
});
