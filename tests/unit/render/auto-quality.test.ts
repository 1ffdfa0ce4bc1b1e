import { describe, expect, test } from "vitest";
import { AutoQuality, type Rung, WORK } from "../../../src/render/auto-quality.ts";
import { tierNamed } from "../../../src/render/quality.ts";
import { SOFTWARE_PIXEL } from "../../../src/render/speed.ts";

const FRAME = 1 / 60;
const PIXELS = 1280 * 720;

/** A GPU, by the time it takes for things, seconds. */
interface Machine {
  /** For a pixel of the load. */
  readonly pixel: number;
  /** For a pixel of low; `AutoQuality` measures it only from frame to frame. */
  readonly low: number;
  /** Times what `WORK` says of the dearer tiers: how far predictions are off. */
  readonly error?: number;
  /** Time that no resolution saves. */
  readonly fixed?: number;
  /** Frames end with the display's. */
  readonly waits?: boolean;
}

/** A desktop's, an integrated one, and two cores. */
const DESKTOP: Machine = { pixel: 5e-11, low: 6e-10 };
const INTEGRATED: Machine = { pixel: 1.6e-8, low: 1.4e-8 };
const SOFTWARE: Machine = { pixel: 5e-7, low: 6e-8 };
const slowed = (machine: Machine, times: number): Machine => ({
  ...machine,
  pixel: machine.pixel * times,
  low: machine.low * times,
});

function workOn({ pixel, low, error = 1, fixed = 0 }: Machine, { tier, share }: Rung): number {
  const pixels = PIXELS * (tierNamed(tier).resolutionScale * share) ** 2;
  if (tier === "low") return fixed + pixels * low;
  const { pixel: software, gpuPixel } = WORK.physical;
  const work = pixel >= SOFTWARE_PIXEL ? software : gpuPixel;
  return fixed + (pixels + WORK.physical.fixed) * work[tier] * pixel * error;
}

function autoOn({ pixel }: Machine): AutoQuality {
  const auto = new AutoQuality(WORK.physical);
  auto.pixels = PIXELS;
  auto.pixel = pixel;
  return auto;
}

interface Change extends Rung {
  /** Seconds. */
  readonly at: number;
  /** The frame after and the frame before, seconds. */
  readonly frames: readonly [number, number];
}

/** Lets it run for so long, seconds, and lists the rungs it went to. */
function run(auto: AutoQuality, machine: Machine, duration: number): Change[] {
  const changes: Change[] = [];
  let before = 0;
  for (let time = 0; time < duration; ) {
    const work = workOn(machine, auto.rung);
    const seconds =
      machine.waits === false ? Math.max(work, 0.004) : Math.ceil(work / FRAME - 1e-6) * FRAME;
    time += seconds;
    if (before > 0 && changes.at(-1)?.frames[0] === 0) {
      changes[changes.length - 1] = { ...changes.at(-1)!, frames: [seconds, before] };
    }
    before = seconds;
    const rung = auto.rung;
    auto.take(seconds);
    if (auto.wanted) auto.accept();
    if (auto.rung !== rung) changes.push({ ...auto.rung, at: time, frames: [0, before] });
  }
  return changes.filter(({ frames }) => frames[0] > 0);
}

test("It starts where every machine can follow, whatever the load took", () => {
  for (const machine of [DESKTOP, INTEGRATED, SOFTWARE]) {
    expect(autoOn(machine).rung).toEqual({ tier: "low", share: 0.6 });
  }
});

test("A fast machine is at its best within a second, in one step to its tier", () => {
  const changes = run(autoOn(DESKTOP), DESKTOP, 30);
  expect(changes).toHaveLength(1);
  expect(changes[0]).toMatchObject({ tier: "high", share: 1 });
  expect(changes[0]?.at).toBeLessThan(1);
});

test("An integrated GPU gets the tier that it was predicted to hold, and holds it", () => {
  const auto = autoOn(INTEGRATED);
  run(auto, INTEGRATED, 60);
  expect(auto.rung.tier).toBe("medium");
  expect(workOn(INTEGRATED, auto.rung)).toBeLessThan(FRAME);
});

test("By the times of an H200 it stands at high in full HD, and walks with a coarser image", () => {
  const auto = autoOn({ pixel: 6.2e-9, low: 1e-9 });
  auto.pixels = 1920 * 1080;
  // `docs/bench/gpus.json`: seconds at rest, and in motion at full resolution.
  const atRest = { low: 0.0005, medium: 0.0041, high: 0.0044, ultra: 0.0088 };
  const inMotion = { low: 0.0006, medium: 0.0138, high: 0.0169, ultra: 0.0361 };
  const frame = (work: number) => {
    auto.take(Math.ceil(work / FRAME) * FRAME, work);
    if (auto.wanted) auto.accept();
  };
  for (let i = 0; i < 5 / FRAME; i++) frame(atRest[auto.rung.tier]);
  expect(auto.rung).toEqual({ tier: "high", share: 1 });
  for (let i = 0; i < 3 / FRAME; i++) frame(inMotion[auto.rung.tier] * auto.rung.share ** 2);
  expect(inMotion[auto.rung.tier] * auto.rung.share ** 2).toBeLessThan(FRAME);
  expect(auto.rung.tier).not.toBe("low");
});

describe.each([1, 10, 100])("Two cores, slowed %d times", (times) => {
  const machine = slowed(SOFTWARE, times);
  const auto = autoOn(machine);
  const changes = run(auto, machine, 120);

  test("stay at low", () => {
    expect(auto.rung.tier).toBe("low");
    for (const { tier } of changes) expect(tier).toBe("low");
    expect(auto.stillRung.tier).toBe("low");
  });

  test("are never tried out for more than 250 ms", () => {
    for (const { frames } of changes) expect(frames[0] - frames[1]).toBeLessThan(0.25);
  });

  test("come down within three frames or a second and a half", () => {
    const first = workOn(machine, { tier: "low", share: 0.6 });
    if (first > 0.04) expect(changes[0]?.at).toBeLessThan(Math.max(1.5, 4.1 * first));
  });
});

test("A frame of two seconds counts, as one of 50 ms does", () => {
  const auto = autoOn(SOFTWARE);
  const taken = Array.from({ length: 4 }, () => auto.take(2));
  expect(taken).toContain(true);
  expect(auto.rung.share).toBe(0.3);
});

test("A prediction that was too hopeful is taken back, and not tried again", () => {
  const machine = { ...INTEGRATED, error: 3, waits: false };
  const auto = autoOn(machine);
  const changes = run(auto, machine, 120);
  for (const { frames } of changes) expect(frames[0] - frames[1]).toBeLessThan(0.25);
  expect(run(auto, machine, 600)).toEqual([]);
});

test("Without a measured speed no tier is raised", () => {
  const auto = autoOn(DESKTOP);
  auto.pixel = null;
  run(auto, DESKTOP, 60);
  expect(auto.rung).toEqual({ tier: "low", share: 1.5 });
  expect(auto.stillRung).toEqual(auto.rung);
});

test("Processors of many cores draw low at the canvas's resolution, or between, as long as it is fluent", () => {
  for (const { low, share } of [
    { low: 5e-8, share: 1 },
    { low: 2e-8, share: 1.25 },
    { low: 6e-9, share: 1.5 },
  ]) {
    const machine = { ...SOFTWARE, low };
    const auto = autoOn(machine);
    run(auto, machine, 60);
    expect(auto.rung).toEqual({ tier: "low", share });
    expect(workOn(machine, auto.rung)).toBeLessThan(1 / 40);
  }
});

test("A candle alone has the canvas's resolution at 24 frames a second, where a room has 40 of a coarser image", () => {
  const shares = (["plain", "alone"] as const).map((kind) => {
    const auto = new AutoQuality(WORK[kind]);
    auto.pixels = PIXELS;
    auto.pixel = SOFTWARE.pixel;
    run(auto, { ...SOFTWARE, low: 3.6e-8, waits: false }, 60);
    return auto.rung.share;
  });
  expect(shares).toEqual([1.25, 1.5]);
});

test("However small, own candles stay at low on a CPU, and others do not", () => {
  const tiers = (["own", "alone"] as const).map((kind) => {
    const auto = new AutoQuality(WORK[kind]);
    auto.pixels = 200 * 150;
    auto.pixel = SOFTWARE.pixel;
    for (let i = 0; i < 600; i++) {
      auto.take(1 / 60);
      if (auto.wanted) auto.accept();
    }
    return [auto.rung.tier, auto.stillRung.tier];
  });
  expect(tiers).toEqual([
    ["low", "high"],
    ["high", "high"],
  ]);
});

test("A GPU that was measured while it was busy is measured again, twice at most, once its frames are fast", async () => {
  for (const fails of [0, 1, 2]) {
    let measurements = 0;
    const auto = new AutoQuality(WORK.physical, async () => {
      measurements++;
      return measurements > fails ? DESKTOP.pixel : 4e-8;
    });
    auto.pixels = PIXELS;
    auto.pixel = 4e-8;
    for (let i = 0; i < 600; i++) {
      auto.take(FRAME, 0.002);
      await null; // the measurement's promise
      if (auto.wanted) auto.accept();
    }
    expect(measurements).toBe(Math.min(fails + 1, 2));
    expect(auto.rung.tier).toBe(fails < 2 ? "high" : "low");
  }
});

test("A later measurement never makes a machine slower, and none is asked for where frames are slow", async () => {
  const measured: number[] = [];
  const auto = new AutoQuality(WORK.physical, async () => measured.push(1));
  auto.pixels = PIXELS;
  auto.pixel = SOFTWARE.pixel;
  for (let i = 0; i < 600; i++) {
    auto.take(0.03);
    await null;
  }
  expect(measured).toHaveLength(0);
  for (let i = 0; i < 600; i++) {
    auto.take(FRAME);
    await null;
  }
  expect(measured).toHaveLength(2);
  expect(auto.pixel).toBe(SOFTWARE.pixel);
});

test("A picture that nothing follows is drawn at high where that takes a quarter of a second at most", () => {
  expect(autoOn(DESKTOP).stillRung).toEqual({ tier: "high", share: 1 });
  expect(autoOn(INTEGRATED).stillRung).toEqual({ tier: "high", share: 1 });
  for (const times of [1, 10, 100]) {
    expect(autoOn(slowed(SOFTWARE, times)).stillRung.tier).toBe("low");
  }
});

test("Anisotropic filtering is allowed where it was measured to be cheap", () => {
  const auto = autoOn(DESKTOP);
  expect(auto.allowsAnisotropy).toBe(true);
  auto.pixel = 10 * INTEGRATED.pixel;
  expect(auto.allowsAnisotropy).toBe(false);
  auto.pixel = null;
  expect(auto.allowsAnisotropy).toBe(false);
});

test("Unseen it takes the whole resolution of low, unless a rung was too slow; late frames lower it from there", () => {
  const auto = autoOn(SOFTWARE);
  auto.rise();
  expect(auto.rung).toEqual({ tier: "low", share: 1 });
  run(auto, { ...SOFTWARE, fixed: 0.09 }, 8);
  const { rung } = auto;
  expect(rung.share).toBeLessThan(0.7);
  auto.rise();
  expect(auto.rung).toEqual(rung);
});

test("A step that was wanted is dropped when frames become late", () => {
  const auto = autoOn(DESKTOP);
  for (let i = 0; i < 60 && !auto.wanted; i++) auto.take(FRAME);
  expect(auto.wanted).toEqual({ tier: "high", share: 1 });
  expect(auto.rung, "until it is prepared").toEqual({ tier: "low", share: 0.6 });
  for (let i = 0; i < 30; i++) auto.take(0.1);
  expect(auto.wanted).toBeNull();
});

test("It comes to rest on every machine", () => {
  const lows = [1e-10, 1e-9, 7e-9, 2e-8, 4e-8, 8e-8, 2e-7, 1e-6];
  const machines = lows.flatMap((low) =>
    [true, false].flatMap((waits) =>
      [0.3, 1, 3].flatMap((error) =>
        [0, 0.012].map((fixed) => ({ pixel: low / 12, low, waits, error, fixed })),
      ),
    ),
  );
  for (const machine of machines) {
    const auto = autoOn(machine);
    const changes = run(auto, machine, 120);
    expect(run(auto, machine, 600), JSON.stringify({ machine, changes })).toEqual([]);
    // Up and down again once at each rung, and three times at one of them.
    const reversals = changes.filter(({ tier, share }, i) =>
      changes.slice(0, i).some((before) => before.tier === tier && before.share === share),
    );
    expect(reversals.length, JSON.stringify({ machine, changes })).toBeLessThanOrEqual(2 + 6);
  }
});

test("Two cores that were busy for a while get back the resolution that they can hold", () => {
  const machine = { pixel: 5e-7, low: 5e-8, fixed: 0.015, waits: false };
  const auto = autoOn(machine);
  run(auto, machine, 10);
  expect(auto.rung).toEqual({ tier: "low", share: 1 });
  run(auto, { ...machine, fixed: 0.09 }, 8);
  expect(auto.rung.share, "busy").toBeLessThan(0.7);
  run(auto, machine, 30);
  expect(auto.rung).toEqual({ tier: "low", share: 1 });
});

test("Two cores keep their resolution in the first seconds, in which the driver still compiles", () => {
  const machine = { pixel: 5e-7, low: 5e-8, fixed: 0.015, waits: false };
  const auto = autoOn(machine);
  expect(run(auto, { ...machine, fixed: 0.045 }, 3)).toEqual([]);
  expect(auto.rung).toEqual({ tier: "low", share: 0.6 });
  run(auto, machine, 6);
  expect(auto.rung).toEqual({ tier: "low", share: 1 });
});

test("Less than a second of late frames changes nothing once it has been slow", () => {
  const auto = autoOn(SOFTWARE);
  for (let i = 0; i < 8; i++) auto.take(0.2);
  const { rung } = auto;
  for (let i = 0; i < 6000; i++) {
    // A tenth of a second late every other second.
    auto.take(i % 100 < 3 ? 0.05 : 1 / 31);
    if (auto.rung.share < rung.share) throw new Error(`lowered at ${i}`);
  }
});

test("Frames that come to nothing are no evidence", () => {
  const auto = autoOn(DESKTOP);
  for (let i = 0; i < 100; i++) {
    expect(auto.take(0)).toBe(false);
    expect(auto.take(Number.NaN)).toBe(false);
  }
  expect(auto.rung).toEqual({ tier: "low", share: 0.6 });
});

test("A GPU that is idle did not make the frames late, and one that is busy did", () => {
  const idle = autoOn(DESKTOP);
  const busy = autoOn(DESKTOP);
  const taken = Array.from({ length: 100 }, () => [idle.take(0.05, 0.004), busy.take(0.05, 0.045)]);
  expect(taken.some(([isLowered]) => isLowered)).toBe(false);
  expect(taken.some(([, isLowered]) => isLowered)).toBe(true);
});

test("What was too slow is tried again after a change that could have helped, and not before", () => {
  const auto = autoOn(DESKTOP);
  const busy = { ...DESKTOP, fixed: 0.1 };
  run(auto, busy, 60);
  const slow = auto.rung;
  expect(slow.tier).toBe("low");
  run(auto, DESKTOP, 60);
  const capped = auto.rung;
  expect(capped).not.toEqual({ tier: "high", share: 1 });
  auto.renew();
  expect(auto.rung, "for now").toEqual(capped);
  run(auto, DESKTOP, 60);
  expect(auto.rung).toEqual({ tier: "high", share: 1 });
});

test("What the driver refuses is tried again in another context alone", () => {
  const auto = autoOn(DESKTOP);
  auto.refuse("medium");
  for (const isOther of [false, true]) {
    auto.renew(isOther);
    run(auto, DESKTOP, 60);
    expect(auto.rung).toEqual(isOther ? { tier: "high", share: 1 } : { tier: "low", share: 1.5 });
  }
});
