// `auto` on GPUs far slower than SwiftShader: every draw is made so many times over.
import type { Page } from "playwright/test";
import { QUICK_ROOM } from "../support/plain-room.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

/** Makes each draw as often as `globalThis.times` says. */
async function slowDown(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const { drawArrays, drawElements } = gl;
    const times = () => Number(Reflect.get(globalThis, "times") ?? 1);
    gl.drawArrays = function (...call) {
      for (let i = 0; i < times(); i++) drawArrays.apply(this, call);
    };
    gl.drawElements = function (...call) {
      for (let i = 0; i < times(); i++) drawElements.apply(this, call);
    };
  });
}

interface Trace {
  /** From frame to frame, seconds, with the canvas's width as of each. */
  readonly frames: readonly { readonly seconds: number; readonly width: number }[];
  readonly tiers: readonly string[];
  /** From a key to its handler, milliseconds. */
  readonly delays: readonly number[];
  readonly isDone: boolean;
}

for (const { times, width, height } of [
  { times: 10, width: 640, height: 360 },
  { times: 40, width: 192, height: 108 },
]) {
  test(`${times} times slower than a CPU it comes down, and is answered within 250 ms`, async ({
    page,
  }) => {
    await slowDown(page);
    await serveSmallTextures(page);
    const room = await new RoomDriver(page).open(
      { look: "physical", quality: "auto", controls: "" },
      { width, height, model: QUICK_ROOM },
    );
    // Who walks sees the coarse image; at rest it is refined, and its frames say nothing.
    await room.evaluate((element) => element.focus());
    await page.keyboard.press("Enter");
    await room.evaluate((element, times) => {
      const trace = {
        frames: [] as { seconds: number; width: number }[],
        tiers: [] as string[],
        delays: [] as number[],
        isDone: false,
      };
      Object.assign(globalThis, { times, trace });
      addEventListener("keydown", ({ timeStamp }) => {
        trace.delays.push(performance.now() - timeStamp);
      });
      element.addEventListener("qualitychange", () => trace.tiers.push(element.stats.quality));
      let last = Number.NaN;
      let begin = Number.NaN;
      const frame = (now: number) => {
        trace.frames.push({ seconds: (now - last) / 1000, width: element.stats.width });
        last = now;
        if (Number.isNaN(begin)) begin = now;
        // What is late is judged after three frames and a second.
        const isCoarser = element.stats.width < (trace.frames[1]?.width ?? 0);
        const isTooLong = now - begin > 30_000 && trace.frames.length > 60;
        trace.isDone = isCoarser ? trace.frames.length > 6 : isTooLong;
        if (!trace.isDone) requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
      element.play();
    }, times);
    const traced = () => page.evaluate(() => Reflect.get(globalThis, "trace") as Trace);
    // The key stays down and repeats, so that each frame turns: one at rest may be cheap enough.
    while (!(await traced()).isDone) await page.keyboard.down("q");
    const { frames, tiers, delays } = await traced();
    test.info().annotations.push({ type: "trace", description: JSON.stringify(frames) });
    const [first, ...rest] = frames.slice(1);
    expect(rest.at(-1)?.width, "coarser than it began").toBeLessThan(first?.width ?? 0);
    expect(new Set(tiers)).toEqual(new Set(["low"]));
    for (const [i, { seconds, width }] of rest.entries()) {
      const before = frames[i + 1];
      if (!before || width <= before.width) continue;
      expect(seconds - before.seconds, "of a finer picture").toBeLessThan(0.25);
    }
    // The script of a frame is not what is slow.
    expect(delays.length).toBeGreaterThan(0);
    expect(delays.toSorted((a, b) => a - b)[delays.length >> 1]).toBeLessThan(250);
  });
}

test("where drawing takes no time it rises to `high`: no frame has many draws, or none, and nothing is left", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    // In the newest frame; the most in one, and the most frames on end without any. What tasks draw does not count.
    const draws = { time: 0, frames: 0, now: 0, most: 0, idle: 0, mostIdle: 0, isFrame: false };
    Object.assign(globalThis, { draws });
    gl.drawArrays = gl.drawElements = () => {
      if (draws.isFrame) draws.now++;
    };
    const { requestAnimationFrame } = globalThis;
    globalThis.requestAnimationFrame = (callback) =>
      requestAnimationFrame((time) => {
        if (time !== draws.time) {
          draws.idle = draws.now > 0 ? 0 : draws.idle + 1;
          draws.mostIdle = Math.max(draws.mostIdle, draws.idle);
          draws.most = Math.max(draws.most, draws.now);
          Object.assign(draws, { time, now: 0, frames: draws.frames + 1 });
        }
        draws.isFrame = true;
        callback((draws.frames * 1000) / 60);
        draws.isFrame = false;
      });
    // A display that never waits, and a clock by which other work on the machine takes no time, either.
    const now = performance.now.bind(performance);
    performance.now = () => now() / 100;
  });
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open(
    { look: "physical", quality: "auto" },
    { width: 1280, height: 720, paused: false },
  );
  const { reached, draws, again } = await room.evaluate(async (element) => {
    const draws = Reflect.get(globalThis, "draws") as Record<"most" | "mostIdle", number>;
    const framesUntil = async (isDone: (frame: number) => boolean) => {
      for (let i = 0; !isDone(i); i++) await new Promise(requestAnimationFrame);
    };
    Object.assign(draws, { most: 0 });
    await framesUntil(() => draws.most > 0); // the GPU is done with the first frame
    Object.assign(draws, { most: 0, idle: 0, mostIdle: 0 });
    await framesUntil(
      () => element.stats.quality === "high" && element.stats.resolutionScale === 1,
    );
    await framesUntil((frame) => frame === 10);
    const reached = { ...element.stats };
    const { most, mostIdle } = draws;
    element.quality = "high";
    // But for programs and the measured load.
    await framesUntil(() => element.stats.gpuBytes > reached.gpuBytes - 4e6);
    return { reached, draws: { most, mostIdle }, again: { ...element.stats } };
  });
  expect(reached).toMatchObject({ quality: "high", resolutionScale: 1 });
  expect(draws.most).toBeGreaterThan(10);
  expect(draws.most, "in a frame: the new tier is prepared in tasks").toBeLessThanOrEqual(120);
  expect(draws.mostIdle, "frames without a draw: the tier before goes on").toBeLessThanOrEqual(3);
  expect(reached.gpuBytes, "of the tier before").toBeLessThan(again.gpuBytes + 4e6);
  expect(room.complaints).toEqual([]);
});

test("while the first frame is drawn nothing is asked of the driver that would wait for it, and nothing all the time", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const waits = { pending: 0, longest: 0, pauses: [] as number[], meanwhile: [] as string[] };
    Object.assign(globalThis, { waits });
    const { fenceSync, clientWaitSync } = gl;
    gl.fenceSync = function (...call) {
      waits.pending++;
      return fenceSync.apply(this, call);
    };
    let polls = 0;
    let last = 0;
    gl.clientWaitSync = function (...call) {
      const status = clientWaitSync.apply(this, call);
      const now = performance.now();
      if (polls > 20) waits.pauses.push(now - last);
      last = now;
      if (status === this.TIMEOUT_EXPIRED) waits.longest = Math.max(waits.longest, ++polls);
      else {
        waits.pending--;
        polls = 0;
      }
      return status;
    };
    for (const name of [
      "drawArrays",
      "drawElements",
      "getActiveUniform",
      "checkFramebufferStatus",
    ] as const) {
      const original = gl[name] as (...call: unknown[]) => unknown;
      Object.assign(gl, {
        [name](this: WebGL2RenderingContext, ...call: unknown[]) {
          if (waits.pending > 0) waits.meanwhile.push(name);
          return original.apply(this, call);
        },
      });
    }
  });
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open(
    { look: "physical", quality: "low" },
    { width: 640, height: 360, paused: false },
  );
  // Frames of the animation loop, of which the first ones come while the first is drawn.
  await room.evaluate(async () => {
    for (let i = 0; i < 30; i++) await new Promise(requestAnimationFrame);
  });
  const waits = await page.evaluate(
    () =>
      Reflect.get(globalThis, "waits") as {
        longest: number;
        pauses: number[];
        meanwhile: string[];
      },
  );
  expect(waits.longest, "times that it was not done yet").toBeGreaterThan(3);
  // Without a pause this thread would take the processor from the renderer.
  console.log(`least pause ${Math.min(...waits.pauses).toFixed(2)} ms of ${waits.pauses.length}`);
  expect(waits.pauses.length).toBeGreaterThan(3);
  expect(Math.min(...waits.pauses), "milliseconds between two questions").toBeGreaterThan(0.7);
  expect(waits.meanwhile).toEqual([]);
});
