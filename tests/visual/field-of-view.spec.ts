import { QUICK_ROOM } from "../support/plain-room.ts";
import type { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const PHYSICAL = (56 * Math.PI) / 180;
const PAPER = Math.PI / 4;

const fieldOfView = (room: RoomDriver) => room.evaluate(({ camera }) => camera.fieldOfView);

/** How far beside the middle the flame is in the picture, and should be, in pixels. */
const offsetsOf = (room: RoomDriver, fieldOfView: number, box: [number, number]) =>
  room.evaluate(
    async (element, { fieldOfView, box }) => {
      element.style.cssText = `width: ${box[0]}px; height: ${box[1]}px`;
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      element.camera = { position: [0, 1.6, 1], yaw: 0, pitch: 0, fieldOfView };
      element.step(0);
      const { width, height } = element.stats;
      const flame = element.look === "paper" ? "particles" : "volume";
      const withFlame = element.readRadiance(0, 0, width, height);
      element.features[flame] = false;
      element.step(0);
      const without = element.readRadiance(0, 0, width, height);
      element.features[flame] = true;
      let sum = 0;
      let weights = 0;
      for (let i = 0; i < width * height; i++) {
        const weight = ((withFlame[3 * i] ?? 0) - (without[3 * i] ?? 0)) ** 2;
        sum += weight * ((i % width) + 0.5 - width / 2);
        weights += weight;
      }
      const [x = 0, , z = 0] = element.flame?.position ?? [];
      const [eyeX, , eyeZ] = element.camera.position;
      const slope = (x - eyeX) / (eyeZ - z);
      const wanted = (slope / Math.tan(fieldOfView / 2)) * (Math.min(width, height) / 2);
      element.style.cssText = "";
      return { found: sum / weights, wanted };
    },
    { fieldOfView, box },
  );

/** @param fields in which the flame is in the picture, and wider than a pixel */
async function expectAcrossShorterSide(
  room: RoomDriver,
  side: number,
  fields: number[],
): Promise<void> {
  for (const box of [
    [2 * side, side],
    [side, 2 * side],
  ] as [number, number][]) {
    for (const fieldOfView of fields) {
      const { found, wanted } = await offsetsOf(room, fieldOfView, box);
      expect(
        Math.abs(found - wanted),
        `${box} ${fieldOfView}: ${found}, not ${wanted}`,
      ).toBeLessThan(1.5);
      expect(Math.abs(wanted)).toBeGreaterThan(8);
    }
  }
}

test("The field of view is the look's own until one is set, and that stays, in any look", async ({
  room,
}) => {
  expect(await fieldOfView(room)).toBeCloseTo(PAPER, 12);
  // What is written as it was read leaves it to the look.
  await room.stand({ yaw: 1 });
  await room.set({ quality: "low" });
  const cabin = /cabin\.glb$/;
  await room.page.route(cabin, (route) =>
    route.fulfill({ contentType: "model/gltf-binary", body: QUICK_ROOM }),
  );
  await room.change("physical");
  await room.page.unroute(cabin);
  expect(await fieldOfView(room)).toBeCloseTo(PHYSICAL, 12);
  await expectAcrossShorterSide(room, 144, [1]);
  await room.stand({ fieldOfView: PHYSICAL });
  const count = await room.evaluate(async (element) => {
    let count = 0;
    const stop = new AbortController();
    element.addEventListener("camerachange", () => count++, { signal: stop.signal });
    element.camera = { fieldOfView: 1.3 };
    element.camera = { fieldOfView: 1.3 };
    stop.abort();
    return count;
  });
  expect(count).toBe(1);
  await room.change("paper");
  expect(await fieldOfView(room)).toBe(1.3);
  const mirrored = await room.evaluate(async (element) => {
    const second = element.cloneNode() as typeof element;
    document.body.append(second);
    await second.ready;
    const before = second.camera.fieldOfView;
    second.mirror(element);
    const { fieldOfView } = second.camera;
    second.remove();
    return { before, fieldOfView };
  });
  expect(mirrored).toEqual({ before: PAPER, fieldOfView: 1.3 });
  await room.evaluate((element) => element.reset());
  expect(await fieldOfView(room)).toBeCloseTo(PAPER, 12);
});

test("It stays within 0.3 and 2.1, and what is no number changes nothing", async ({ room }) => {
  const found = await room.evaluate((element) => {
    const values = [9, Infinity, 0, -1e9, 1.1, Number.NaN, "wide", null, {}, undefined];
    return values.map((value) => {
      Reflect.set(element, "camera", { fieldOfView: value });
      return element.camera.fieldOfView;
    });
  });
  expect(found).toEqual([2.1, 2.1, 0.3, 0.3, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1]);
});

test("It may be set before there is a picture, with or without a look", async ({ room }) => {
  const found = await room.page.evaluate(async () => {
    const made = async (fieldOfView?: number) => {
      const element = document.createElement("candle-flame");
      const { camera } = element;
      element.camera = fieldOfView ? { fieldOfView } : camera;
      Object.assign(element, { look: "paper", quality: "low", paused: true });
      element.style.cssText = "width: 32px; height: 18px";
      const before = element.camera.fieldOfView;
      document.body.append(element);
      await element.ready;
      const after = element.camera.fieldOfView;
      element.remove();
      return [before, after];
    };
    return [await made(), await made(1.9)];
  });
  expect(found).toEqual([
    [PAPER, PAPER],
    [1.9, 1.9],
  ]);
});

test("It is across the picture's shorter side, wide and upright", async ({ room }) => {
  await expectAcrossShorterSide(room, 96, [1.1, 1.7]);
});
