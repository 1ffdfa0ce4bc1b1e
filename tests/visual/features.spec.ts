import {
  allFeatures,
  FEATURES,
  type Feature,
  featuresOf,
  INSPECTIONS,
  type Inspection,
  SETTINGS,
} from "../../src/settings.ts";
import type { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** Without a feature the picture is another than the whole one, and with it again the same. */
async function expectSwitch(room: RoomDriver, feature: Feature, whole: string): Promise<void> {
  const without = await room.pixels({ features: { [feature]: false } });
  expect(without, `without ${feature}`).not.toBe(whole);
  const again = await room.pixels({ features: { [feature]: true } });
  expect(again, `with ${feature} again`).toBe(whole);
}

for (const feature of featuresOf("paper")) {
  test(`Without ${feature} the paper's picture is another, and with it again the same`, async ({
    room,
  }) => {
    // Near the crest of the flicker.
    await expectSwitch(room, feature, await room.pixels({ seconds: 0.1 }));
  });
}

test.describe("In the cabin", () => {
  test.beforeEach(({ cabin }) => cabin.set({ quality: "medium" }));

  test("the physical picture is another without each of its own features", async ({
    cabin: room,
  }) => {
    const whole = await room.pixels();
    for (const feature of featuresOf("physical")) {
      // At rest and at this size there is none of it to be seen: plume.spec.ts.
      if (feature === "smoke" || feature === "sparks" || feature === "dust") continue;
      const features = { ...allFeatures(), [feature]: false };
      expect(await room.pixels({ features }), `without ${feature}`).not.toBe(whole);
    }
    expect(await room.pixels({ features: allFeatures() }), "with all of them again").toBe(whole);
  });

  test("a candle that is hidden casts no shadow below its flame", async ({ cabin: room }) => {
    const share = await room.evaluate((element) => {
      const { camera } = element;
      element.features.candle = false;
      element.camera = { position: [0, 1.6, 1.2], yaw: 0, pitch: -1.3 };
      const read = (shadows: boolean) => {
        element.features.shadows = shadows;
        element.step(0);
        return element.readRadiance(73, 33, 27, 24);
      };
      const [lit, unshadowed] = [read(true), read(false)];
      Object.assign(element.features, { candle: true, shadows: true });
      element.camera = camera;
      element.step(0);
      const shares = Array.from(lit, (x, i) => x / (unshadowed[i] ?? 0));
      return shares.reduce((a, b) => Math.min(a, b));
    });
    expect(share).toBeGreaterThan(0.9);
  });

  test("each pass of the physical look can be looked at alone", async ({ cabin: room }) => {
    const whole = await room.pixels();
    const seen = new Map<string, string>();
    for (const name of INSPECTIONS) {
      const pixels = await room.pixels({ inspect: name });
      expect(seen.get(pixels), name).toBeUndefined();
      seen.set(pixels, name);
    }
    expect(seen.get(whole)).toBe("picture");
    const { data } = await room.picture({ inspect: "depth" });
    expect(Math.max(...data.filter((_, i) => i % 4 === 0))).toBeGreaterThan(150);
    expect(await room.pixels({ inspect: "nonsense" as Inspection })).toBe(whole);
    expect(await room.evaluate((element) => element.inspect)).toBe("picture");
  });

  test("a pass is looked at in the primaries that it has, on a Display P3 screen, too", async ({
    cabin: room,
  }) => {
    const client = await room.page.context().newCDPSession(room.page);
    const emulate = (features: { name: string; value: string }[]) =>
      client.send("Emulation.setEmulatedMedia", { features });
    await emulate([{ name: "color-gamut", value: "p3" }]);
    const spaces = await room.evaluate((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      const views = ["picture", "radiance", "picture"] as const;
      return views.map((view) => {
        element.inspect = view;
        element.step(0);
        return canvas?.getContext("webgl2")?.drawingBufferColorSpace;
      });
    });
    await emulate([]);
    await client.detach();
    expect(spaces).toEqual(["display-p3", "srgb", "display-p3"]);
  });
});

test("Every feature is one that some look has", () => {
  const known = new Set(SETTINGS.look.choices.flatMap((look) => featuresOf(look)));
  expect([...known].sort()).toEqual([...FEATURES].sort());
});

test("Features are given as one object, or one by one, and unknown ones are refused", async ({
  room,
}) => {
  const states = await room.evaluate((element) => {
    element.features = { drift: false, core: false } as typeof element.features;
    const { drift, core, hazeLayer } = element.features;
    element.features.drift = true;
    let refusal = "";
    try {
      Object.assign(element.features, { sparkle: true });
    } catch (error) {
      refusal = (error as Error).name;
    }
    return { drift, core, hazeLayer, driftAgain: element.features.drift, refusal };
  });
  expect(states).toEqual({
    drift: false,
    core: false,
    hazeLayer: true,
    driftAgain: true,
    refusal: "TypeError",
  });
});

test("The original has fewer techniques to switch, and says which", async ({ room }) => {
  await room.set({ look: "original" });
  await room.step(0.1);
  for (const feature of featuresOf("original"))
    await expectSwitch(room, feature, await room.pixels());
  const whole = await room.pixels();
  const others = featuresOf("paper").filter((name) => !featuresOf("original").includes(name));
  await room.switchFeatures(Object.fromEntries(others.map((name) => [name, false])));
  expect(await room.pixels()).toBe(whole);
});

test("Fewer particles burn the farther the candle is, and all of them again near it", async ({
  room,
}) => {
  await room.set({ look: "paper" });
  const counts: number[] = [];
  const count = async () => {
    await room.step(1 / 20, 40); // longer than any particle lives
    counts.push((await room.stats()).particles);
  };
  await room.stand({ position: [4.5, 1.6, 4.5], yaw: -Math.PI / 4, pitch: 0 });
  await count();
  await room.evaluate((element) => element.place());
  for (const [x, z] of [
    [3, 3],
    [0, 0],
    [-4.5, -4.5],
    [4.5, 4.5],
  ] as const) {
    await room.stand({ position: [x, 1.6, z] });
    await count();
  }
  const [held = 0, near = 0, amid = 0, far = 0, back = 0] = counts;
  expect(held).toBe(800);
  expect(near).toBe(held);
  expect(amid).toBeLessThan(near);
  expect(far).toBeLessThan(amid);
  expect(far).toBeGreaterThan(0);
  expect(back).toBe(held);
});

test("With reduced motion the flame does not flicker", async ({ room }) => {
  await room.page.emulateMedia({ reducedMotion: "reduce" });
  try {
    await room.set({ look: "paper" });
    await room.step(0.1);
    const still = await room.pixels();
    await room.switchFeatures({ flicker: false });
    expect(await room.pixels()).toBe(still);
    await room.set({ motion: "full" });
    await room.switchFeatures({ flicker: true });
    expect(await room.pixels()).not.toBe(still);
    await room.page.emulateMedia({ reducedMotion: null });
    await room.set({ motion: "reduced" });
    expect(await room.pixels()).toBe(still);
  } finally {
    await room.page.emulateMedia({ reducedMotion: null });
  }
});
