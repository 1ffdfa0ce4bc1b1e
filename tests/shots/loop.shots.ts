import { writeFileSync } from "node:fs";
import { expect, test } from "playwright/test";
import sharp from "sharp";
import { RoomDriver } from "../support/room-driver.ts";
import { animatedWebp } from "./animated-webp.ts";

/** Frames a second, and seconds of the loop. */
const RATE = 20;
const LENGTH = 6;
/** Pixels of a frame as it is drawn, and as it is stored: smaller, so that edges are smooth. */
const DRAWN = { width: 720, height: 405 };
const STORED = { width: 640, height: 360 };
/** Bytes of the file, and the qualities that are tried until it fits. */
const MOST_BYTES = 1_500_000;
const QUALITIES = [70, 65, 60, 55, 50, 45, 40];
/** Device pixels for a CSS pixel while no frame is kept: every step draws. */
const TINY = "0.1";

const START = { position: [-1.55, 1.6, 1.3], yaw: -0.3 * Math.PI, pitch: -0.08 } as const;
/** Seconds at which the candle is blown out and lit again. */
const BLOW = 2.3;
const LIGHT = 3.4;
/** Sticks of a gamepad at their furthest: right, back, turn right, look down. */
const STICKS = [0.6, -0.55, -0.48, 0] as const;
/** Seconds in which the candle is carried, there and back. */
const WAYS = [
  { begin: 0, end: 2.1, sign: 1 },
  { begin: 3.9, end: 6, sign: -1 },
] as const;

function sticksAt(second: number): number[] {
  const way = WAYS.find(({ begin, end }) => second >= begin && second < end);
  if (!way) return STICKS.map(() => 0);
  const share = Math.sin((Math.PI * (second - way.begin)) / (way.end - way.begin)) ** 2;
  return STICKS.map((stick) => stick * share * way.sign);
}

/** Goes through the loop once, step by step, and returns its frames as PNG files if they are kept. */
async function perform(room: RoomDriver, isKept: boolean): Promise<Buffer[]> {
  const frames: Buffer[] = [];
  for (let frame = 0; frame < LENGTH * RATE; frame++) {
    await room.page.evaluate(
      (axes) => {
        const pad = { mapping: "standard", axes, buttons: [] };
        navigator.getGamepads = () => [pad] as unknown as Gamepad[];
      },
      sticksAt(frame / RATE),
    );
    if (frame === BLOW * RATE) await room.evaluate((element) => element.blow());
    if (frame === LIGHT * RATE) await room.evaluate((element) => element.light());
    if (isKept) frames.push(await room.png({ seconds: 1 / RATE }));
    else await room.step(1 / RATE);
  }
  return frames;
}

function compressed(frames: readonly Buffer[], quality: number): Promise<Buffer[]> {
  return Promise.all(
    frames.map((frame) => {
      const { width, height } = STORED;
      return sharp(frame)
        .removeAlpha()
        .resize(width, height)
        .webp({ quality, effort: 6 })
        .toBuffer();
    }),
  );
}

test("shot: the candle is carried, blown out, and lit again, in a loop", async ({ page }) => {
  test.setTimeout(1_800_000); // a CPU draws a frame in seconds
  const attributes = { look: "physical", quality: "high", controls: "", motion: "full" };
  const room = await new RoomDriver(page).open({ ...attributes, "max-pixel-ratio": TINY }, DRAWN);
  await room.stand(START);
  await room.evaluate((element) => element.enter());
  // Smoke and exposure at the beginning are those at the end.
  await perform(room, false);
  await room.stand(START);
  await room.set({ "max-pixel-ratio": "1" });
  const frames = await perform(room, true);
  expect(room.complaints).toEqual([]);
  for (const quality of QUALITIES) {
    const file = animatedWebp(await compressed(frames, quality), STORED, 1000 / RATE);
    if (file.length > MOST_BYTES) continue;
    writeFileSync("docs/shots/loop.webp", file);
    return;
  }
  throw new Error(`No quality makes the loop smaller than ${MOST_BYTES} bytes.`);
});
