import type { Page } from "playwright/test";
import { FlashMeter } from "../support/flash.ts";
import { drawOneSample } from "../support/one-sample.ts";
import { plainRoom } from "../support/plain-room.ts";
import { type Attributes, RoomDriver } from "../support/room-driver.ts";
import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

const ROOM = { min: [-3, 0, -3], max: [3, 3, 3] } as const;
/** So high that one goes below it: an eye can be as near to a candle on it as it likes. */
const SHELF = { min: [-0.2, 1.72, -0.2], max: [0.2, 1.75, 0.2] } as const;
const STAGE_FIELD = (56 * Math.PI) / 180;

/** A room of one reflectance, with nothing in it but a shelf. */
async function openPlain(
  page: Page,
  albedo: number,
  size: { width: number; height: number },
  attributes: Attributes = {},
) {
  await drawOneSample(page);
  const model = plainRoom(ROOM, [SHELF], albedo);
  return new RoomDriver(page).open(
    { look: "physical", quality: "low", ...attributes },
    { ...size, model },
  );
}

test("Light integrated over the picture is the flame's, from all sides, straight and leaning, far and near", async ({
  page,
}) => {
  const size = { width: 160, height: 160 };
  const still = { quality: "medium", wind: "0", gustiness: "0" };
  const room = await openPlain(page, 0, size, still);
  const dark = ["candle", "specular", "indirect", "shadows", "smoke", "haze", "bloom"] as const;
  await room.switchFeatures(Object.fromEntries(dark.map((name) => [name, false])));
  for (const [wind, gustiness, seconds] of [
    [0, 0, 1.5],
    [0.5, 0, 1.5],
    [1.2, 1, 0.7], // gusts have bent it level
  ] as const) {
    const shares = await room.evaluate(
      (element, { wind, gustiness, seconds, pixel, size }) => {
        element.take();
        element.camera = { position: [0, 2.2, 0.5], yaw: 0, pitch: -0.73 };
        element.place();
        element.wind = wind;
        element.gustiness = gustiness;
        element.step(seconds);
        const { flame } = element;
        if (!flame || element.held) throw new Error("There is no flame that stands.");
        const [x, y, z] = flame.position;
        const eighths = [0, 1, 2, 3, 4, 5, 6, 7].map((eighth) => [(eighth * Math.PI) / 4, 0.45]);
        // It is four pixels high and one wide, then half of that, and falls between them by and by.
        const far = [1.5, 2.6].flatMap((away) =>
          eighths.map((_, i) => [0, away, 0.37 * i * pixel]),
        );
        return [...eighths, ...far, [0, 0.1]].map(([yaw = 0, away = 0, turn = 0]) => {
          const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)];
          const position = [x + away * sin, y, z + away * cos] as const;
          element.camera = { position, yaw: yaw + turn, pitch: turn };
          const radiance = element.readRadiance(0, 0, size.width, size.height);
          let sum = 0;
          for (let i = 0; i < size.width * size.height; i++) {
            const [red = 0, green = 0, blue = 0] = radiance.subarray(i * 3);
            const u = ((i % size.width) + 0.5 - size.width / 2) * pixel;
            const v = (Math.floor(i / size.width) + 0.5 - size.height / 2) * pixel;
            // A pixel's solid angle, seen askew, on a surface that faces the flame.
            const angle = (pixel * pixel) / (1 + u * u + v * v) ** 2;
            sum += (0.2126729 * red + 0.7151522 * green + 0.072175 * blue) * angle;
          }
          const [eyeX, eyeY, eyeZ] = element.camera.position;
          const distance = Math.hypot(x - eyeX, y - eyeY, z - eyeZ);
          if (Math.abs(distance - away) > 1e-3) throw new Error(`The eye is ${distance} m away.`);
          return (sum * away * away) / flame.luminousIntensity;
        });
      },
      { wind, gustiness, seconds, pixel: (2 * Math.tan(STAGE_FIELD / 2)) / size.height, size },
    );
    const found = `${wind} m/s: ${shares.map((share) => share.toFixed(3)).join(" ")}`;
    console.log(found);
    const near = shares.pop() ?? 0;
    for (const share of shares.splice(8)) expect(Math.abs(share - 1), found).toBeLessThan(0.2);
    const mean = shares.reduce((total, share) => total + share / 8, 0);
    // Its ends are farther from 10 cm away than its middle, and light that aslant.
    expect(near / mean, found).toBeGreaterThan(0.95);
    expect(near / mean, found).toBeLessThan(1.01);
    expect(Math.abs(mean - 1), found).toBeLessThan(0.1);
    // Seen along a level flame, soot absorbs more.
    for (const share of gustiness === 0 ? shares : []) {
      expect(Math.abs(share - 1), found).toBeLessThan(0.1);
      expect(Math.abs(share / mean - 1), found).toBeLessThan(0.05);
    }
  }
  expect(room.complaints).toEqual([]);
});

for (const [quality, most] of [
  ["low", 0.2],
  ["high", 0.12],
] as const) {
  test(`Wax below a flame that is blown over its edge is lit evenly, ${quality}`, async ({
    page,
  }) => {
    const size = { width: 160, height: 160 };
    const room = await openPlain(page, 0.5, size, {
      quality,
      wind: "1",
      "wind-direction": "180",
    });
    const steps = await room.evaluate((element) => {
      element.take();
      element.camera = { position: [0, 2.2, 0.5], yaw: 0, pitch: -0.73 };
      element.place();
      element.step(1);
      const [x, y, z] = element.candles[0]?.position ?? [Number.NaN, Number.NaN, Number.NaN];
      const position = [x, y - 0.05, z + 0.35] as const;
      element.camera = { position, yaw: 0, pitch: 0, fieldOfView: 0.3 };
      element.step(0.1);
      const { width, height } = element.stats;
      const radiance = element.readRadiance(0, 0, width, height);
      const red = (column: number, row: number) => radiance[3 * (row * width + column)] ?? 0;
      const steps: number[] = [];
      // Beside a run of wax.
      for (let row = Math.ceil(0.2 * height); row < 0.75 * height; row++) {
        for (let column = Math.ceil(0.42 * width); column < 0.52 * width; column++) {
          steps.push(Math.abs(Math.log(red(column, row + 1) / red(column, row))));
        }
      }
      return steps.sort((a, b) => a - b);
    });
    const steep = steps[Math.floor(0.95 * steps.length)] ?? Number.NaN;
    console.log(`${quality}: ${steep.toFixed(3)} from row to row in the steepest twentieth`);
    expect(steep).toBeLessThan(most);
    expect(room.complaints).toEqual([]);
  });
}

test("A flame that a gust blows over is drawn once in each pixel", async ({ page }) => {
  await openSources(page);
  for (const degrees of [0, 90, 190]) {
    const shares = await page.evaluate(
      async ({ module, direction }) => {
        const { drawnTwice }: typeof import("../support/flame-hull.ts") = await import(module);
        return drawnTwice(direction, 0.3);
      },
      { module: "/tests/support/flame-hull.ts", direction: (degrees * Math.PI) / 180 },
    );
    const found = `${degrees}°: ${shares.map((share) => share.toFixed(3)).join(" ")}`;
    console.log(`drawn twice, ${found}`);
    expect(Math.max(...shares), found).toBeLessThan(0.15);
  }
});

/** Frames of seconds at 60 Hz, at half of the size and averaged; `deed` is done before each. */
async function film(
  room: RoomDriver,
  seconds: number,
  deeds: Readonly<Record<number, "light" | "extinguish">>,
): Promise<FlashMeter> {
  const [width, height] = [64, 48];
  const meter = new FlashMeter(width, height);
  const frames = Math.round(seconds * 60);
  const text = await room.evaluate(
    (element, { frames, deeds, width, height }) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const paper = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
      if (!canvas || !paper) throw new Error("There is no canvas.");
      let text = "";
      for (let frame = 0; frame < frames; frame++) {
        const deed = deeds[frame];
        if (deed) element[deed]();
        element.step(1 / 60);
        paper.drawImage(canvas, 0, 0, width, height);
        const { data } = paper.getImageData(0, 0, width, height);
        for (let i = 0; i < data.length; i++) text += String.fromCharCode(data[i] ?? 0);
      }
      return btoa(text);
    },
    { frames, deeds, width, height },
  );
  const bytes = Buffer.from(text, "base64");
  const length = width * height * 4;
  for (let frame = 0; frame < frames; frame++) {
    meter.look(bytes.subarray(frame * length, (frame + 1) * length), frame / 60);
  }
  return meter;
}

test.describe("No picture flashes", () => {
  const SIZE = { width: 128, height: 96 };

  test("physical: the widest wick in gusts, blown out, lit, and toggled quickly", async ({
    page,
  }) => {
    const room = await openPlain(page, 0.8, SIZE);
    await room.set({ wick: "50", wind: "0.5", gustiness: "1", exposure: "1" });
    await room.evaluate((element) => {
      element.camera = { position: [0, 1.6, -1.6], yaw: 0, pitch: -0.1 };
    });
    const deeds: Record<number, "light" | "extinguish"> = {};
    for (let i = 0; i < 8; i++) deeds[70 + i * 8] = i % 2 === 0 ? "extinguish" : "light";
    const { worst, isHarmful } = await film(room, 2.3, deeds);
    console.log("physical", worst);
    expect(isHarmful).toBe(false);
    expect(room.complaints).toEqual([]);
  });

  test("paper and original: flickering, carried, and toggled quickly", async ({ room }) => {
    for (const look of ["paper", "original"] as const) {
      await room.change(look);
      const deeds: Record<number, "light" | "extinguish"> = {};
      for (let i = 0; i < 10; i++) deeds[10 + i * 7] = i % 2 === 0 ? "extinguish" : "light";
      const { worst, isHarmful } = await film(room, 1.4, deeds);
      console.log(look, worst);
      expect(isHarmful, look).toBe(false);
    }
  });
});

test("The flame is lit and put out by method, key and breath, with one event each", async ({
  room,
}) => {
  const { page } = room;
  await room.evaluate((element) => {
    const events: string[] = [];
    Object.assign(globalThis, { events });
    for (const type of ["light", "extinguish"] as const) {
      element.addEventListener(type, ({ bubbles }) =>
        events.push(`${type} ${element.lit} ${bubbles}`),
      );
    }
    element.controls = true;
    element.focus();
  });
  /** What was reported since it was last asked, and how the flame is. */
  const events = () =>
    room.evaluate((element) => ({
      events: (globalThis as unknown as { events: string[] }).events.splice(0),
      lit: element.lit,
      shown: element.matches(":state(lit)"),
      flame: element.flame?.lit,
    }));
  const burns = { lit: true, shown: true, flame: true };
  const isOut = { lit: false, shown: false, flame: false };
  expect(await events()).toEqual({ events: [], ...burns });
  await room.evaluate((element) => {
    element.extinguish();
    element.lit = false;
    element.extinguish();
  });
  expect(await events()).toEqual({ events: ["extinguish false false"], ...isOut });
  await room.evaluate((element) => {
    element.step(1);
    element.lit = true;
    element.light();
  });
  expect(await events()).toEqual({ events: ["light true false"], ...burns });
  const { lit, dark } = await room.evaluate((element) => {
    element.step(2);
    const lit = element.flame;
    element.unlit = true;
    element.step(1);
    return { lit, dark: element.flame };
  });
  expect(lit?.luminousIntensity).toBeGreaterThan(0.9);
  expect(lit?.height).toBeGreaterThan(0.02);
  expect(dark).toMatchObject({ lit: false, height: 0, width: 0, luminousIntensity: 0 });
  expect(await events()).toEqual({ events: ["extinguish false false"], ...isOut });
  await room.evaluate((element) => {
    element.unlit = false;
  });
  expect(await events()).toEqual({ events: ["light true false"], ...burns });
  await page.keyboard.press("Enter");
  for (const [key, result] of [
    ["KeyE", { events: ["extinguish false false"], ...isOut }],
    ["KeyE", { events: ["light true false"], ...burns }],
    ["KeyB", { events: ["extinguish false false"], ...isOut }],
  ] as const) {
    await page.keyboard.press(key);
    await room.step(0.6);
    await room.step(0.6);
    expect(await events(), key).toEqual(result);
  }
  await room.evaluate((element) => {
    element.light();
    element.step(1);
    element.blow(0.1);
    element.step(1);
  });
  expect(await events(), "a faint breath").toEqual({ events: ["light true false"], ...burns });
});
