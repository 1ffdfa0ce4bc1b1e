import { hasSparks } from "../../src/world/particles/sparks.ts";
import { TICK } from "../../src/world/timeline.ts";
import type { RoomDriver } from "../support/room-driver.ts";
import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

/** A seed whose wick spits within half a second, and when. */
function soonest(): { seed: number; tick: number } {
  const spits = [...Array(1000).keys()].map((seed) => ({
    seed,
    tick: [...Array(60).keys()].find((tick) => hasSparks(seed, tick)) ?? Number.NaN,
  }));
  return spits.find(({ tick }) => tick > 0) ?? { seed: 0, tick: 0 };
}

test("A flame put out smokes for seconds, and no longer than twenty", async ({ cabin: room }) => {
  await room.set({ quality: "low", controls: "" });
  const withAndWithout = async () => {
    const whole = await room.pixels();
    await room.switchFeatures({ smoke: false });
    const without = await room.pixels();
    await room.switchFeatures({ smoke: true });
    return { whole, without };
  };
  await room.step(0.5);
  const lit = await withAndWithout();
  expect(lit.whole, "a lit candle does not smoke").toBe(lit.without);
  await room.evaluate((element) => {
    element.enter();
    const press = { code: "KeyE", bubbles: true };
    element.dispatchEvent(new KeyboardEvent("keydown", press));
    element.dispatchEvent(new KeyboardEvent("keyup", press));
  });
  await room.step(2);
  const smoking = await withAndWithout();
  expect(smoking.whole, "smoke is seen").not.toBe(smoking.without);
  expect(await brightestSmoke(room), "in the dark it is lit by the ember alone").toBeLessThan(5e-4);
  await room.set({ moonlight: "0.15" });
  const moonlit = await brightestSmoke(room);
  expect(moonlit, "it is lit by the moon, and no more").toBeLessThan(0.02);
  expect(moonlit).toBeGreaterThan(1e-4);
  await room.set({ moonlight: "0" });
  await room.step(18);
  const over = await withAndWithout();
  expect(over.whole, "all smoke has gone").toBe(over.without);
});

/** Radiance that smoke adds in the upper half of the picture, at most, cd/m². */
function brightestSmoke(room: RoomDriver): Promise<number> {
  return room.evaluate((element) => {
    const { width, height } = element.stats;
    const read = (smoke: boolean) => {
      element.features.smoke = smoke;
      return element.readRadiance(0, 0, width, Math.floor(height / 2));
    };
    const without = read(false);
    return read(true).reduce((most, value, i) => Math.max(most, value - (without[i] ?? 0)), 0);
  });
}

test("Hot air refracts the background, dust drifts through the light, and the wick throws sparks", async ({
  cabin: room,
}) => {
  const { seed, tick } = soonest();
  await room.set({ quality: "medium", seed: String(seed), motion: "full" });
  await expectHaze(room);
  await expectMotes(room, tick);
});

async function expectHaze(room: RoomDriver): Promise<void> {
  const differences = await room.evaluate((element) => {
    const { width, height } = element.stats;
    const bent = element.readRadiance(0, 0, width, height);
    element.features.haze = false;
    const plain = element.readRadiance(0, 0, width, height);
    element.features.haze = true;
    const columns: number[] = [];
    const rows: number[] = [];
    let most = 0;
    for (let i = 0; i < width * height; i++) {
      const one = bent[i * 3 + 1] ?? 0;
      const other = plain[i * 3 + 1] ?? 0;
      if (Math.abs(one - other) <= 0.002 * Math.max(one, other)) continue;
      most = Math.max(most, Math.abs(one - other) / Math.max(one, other));
      columns.push(i % width);
      rows.push(Math.floor(i / width));
    }
    element.inspect = "haze"; // how far it moves what is behind it: 0.5 is nowhere
    const offsets = element.readRadiance(0, 0, width, height);
    element.inspect = "picture";
    const far = offsets.reduce((far, share) => Math.max(far, 4 * Math.abs(share - 0.5)), 0);
    return { width, height, columns, rows, most, far };
  });
  const { width, height, columns, rows, most, far } = differences;
  expect(most, "an edge behind it is seen to move").toBeGreaterThan(0.1);
  expect(
    far,
    "by less than a hundredth of the picture, however near the candle is held",
  ).toBeLessThan(0.01 * height);
  expect(far, "and by enough to see").toBeGreaterThan(0.15);
  expect(columns.length, "it is seen").toBeGreaterThan(20);
  // The candle is held right of the middle; its column is a few centimetres wide, and above it.
  expect(Math.max(...columns) - Math.min(...columns)).toBeLessThan(0.2 * width);
  expect(Math.min(...columns)).toBeGreaterThan(0.5 * width);
  expect(Math.max(...rows)).toBeLessThan(0.75 * height);
}

test("Flame and sparks add their light, dust and smoke mix theirs in, and surfaces cut no edge into them", async ({
  page,
}) => {
  await openSources(page);
  const { seed, tick } = soonest();
  const found = await page.evaluate(
    async ({ module, seed, seconds }) => {
      const { mixtures }: typeof import("../support/over-backgrounds.ts") = await import(module);
      return mixtures(seed, seconds);
    },
    { module: "/tests/support/over-backgrounds.ts", seed, seconds: (tick + 6) * TICK },
  );
  const { flame, spark, dust, smoke } = found;
  for (const [name, { pixels, error, fading }] of Object.entries(found)) {
    console.log(name, JSON.stringify(found[name as keyof typeof found]));
    expect(pixels, name).toBeGreaterThan(20);
    expect(error, `${name} takes the same share of any background`).toBeLessThan(1e-5);
    if (name === "flame") continue;
    expect(fading.slice(0, 2), `${name} behind a surface`).toEqual([0, 0]);
    const steps = fading.slice(1).map((share, i) => share - (fading[i] ?? 0));
    expect(Math.min(...steps), `${name} never shows less`).toBeGreaterThan(-1e-6);
    expect(Math.max(...steps), `${name} before a surface comes bit by bit`).toBeLessThan(0.14);
    expect(fading.at(-1), `${name} farther before it is seen`).toBeGreaterThan(0.5);
  }
  expect(spark.opacity, "a spark hides little, lest sums overflow").toBeLessThan(0.05);
  expect(flame.opacity, "nor does a flame hide more than half").toBeLessThan(0.51);
  expect(flame.most, "and adds much").toBeGreaterThan(5000);
  expect(dust.opacity, "a mote hides a bit, being small").toBeGreaterThan(1e-4);
  expect(smoke.opacity, "smoke hides more").toBeGreaterThan(0.1);
  expect(smoke.opacity, "and one sees through it").toBeLessThan(0.9);
});

/** @param tick in which the wick spits */
async function expectMotes(room: RoomDriver, tick: number): Promise<void> {
  /** How many pixels differ with a feature, and by how much at most. */
  const changeBy = (feature: "dust" | "sparks") =>
    room.evaluate((element, feature) => {
      const { width, height } = element.stats;
      const whole = element.readRadiance(0, 0, width, height);
      element.features[feature] = false;
      const without = element.readRadiance(0, 0, width, height);
      element.features[feature] = true;
      const changes = whole.map((light, i) => Math.abs(light - (without[i] ?? 0)));
      const count = changes.filter((change) => change > 1e-3).length / 3;
      const pixels = width * height;
      return { count, pixels, most: changes.reduce((most, change) => Math.max(most, change), 0) };
    }, feature);
  const before = await changeBy("sparks");
  expect(before.most, "a candle at peace throws none").toBe(0);
  await room.step((tick + 6) * TICK);
  const sparks = await changeBy("sparks");
  expect(sparks.most, "a spark shines").toBeGreaterThan(0.1);
  expect(sparks.count, "and is small").toBeLessThan(0.01 * sparks.pixels);
  const dust = await changeBy("dust");
  expect(dust.most, "a mote is seen").toBeGreaterThan(1e-3);
  expect(dust.most, "and no firefly").toBeLessThan(2);
  const isStill = await room.evaluate((element) => {
    const { width, height } = element.stats;
    element.motion = "reduced";
    const before = element.readRadiance(0, 0, width, height);
    element.features.dust = element.features.sparks = false;
    const after = element.readRadiance(0, 0, width, height);
    return before.every((light, i) => light === after[i]);
  });
  expect(isStill, "who asked for less motion sees neither").toBe(true);
}
