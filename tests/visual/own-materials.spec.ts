import sharp from "sharp";
import type { Camera } from "../../src/candle-flame-element.ts";
import { luma } from "../../src/light/color.ts";
import { GlbBuilder } from "../../tools/models/glb-builder.mjs";
import { roomModel } from "../../tools/reference/rooms.mjs";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const SIZE = { width: 160, height: 160 };
/** Middles of two panels, on both sides of the origin, metres. */
const AWAY = 2;

/** Two panels above a floor, seen from +Z: one's back, and one's front that has the same relief from there. */
async function panels(): Promise<Buffer> {
  const builder = new GlbBuilder();
  // A slope along the tangent of 0.6 in 0.8.
  const texel = {
    width: 1,
    height: 1,
    channels: 3,
    background: { r: 204, g: 128, b: 230 },
  } as const;
  const bytes = await sharp({ create: texel }).png().toBuffer();
  const image = builder.add("images", { bufferView: builder.view(bytes), mimeType: "image/png" });
  const normalTexture = { index: builder.add("textures", { source: image }) };
  const pbrMetallicRoughness = { metallicFactor: 0 };
  const mapped = builder.add("materials", {
    pbrMetallicRoughness,
    normalTexture,
    doubleSided: true,
  });
  const plain = builder.add("materials", { pbrMetallicRoughness });
  const square = (corners: number[], normal: number[], tangent: number[], material: number) => ({
    attributes: {
      POSITION: builder.accessor(Float32Array.from(corners), 3),
      NORMAL: builder.accessor(
        Float32Array.from({ length: 12 }, (_, i) => normal[i % 3] ?? 0),
        3,
      ),
      TANGENT: builder.accessor(
        Float32Array.from({ length: 16 }, (_, i) => tangent[i % 4] ?? 0),
        4,
      ),
      TEXCOORD_0: builder.accessor(new Float32Array(8), 2),
    },
    indices: builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3), 1),
    material,
  });
  const panel = (x: number, side: number) =>
    square(
      [-1, 1, 1, -1].flatMap((u, i) => [x + 0.5 * u * side, i < 2 ? 0.8 : 1.8, 0]),
      [0, 0, side],
      [-side, 0, 0, 1],
      mapped,
    );
  const floor = [-4, 0, 4, 4, 0, 4, 4, 0, -4, -4, 0, -4];
  const primitives = [
    square(floor, [0, 1, 0], [1, 0, 0, 1], plain),
    panel(-AWAY, -1),
    panel(AWAY, 1),
  ];
  builder.root({ mesh: builder.add("meshes", { primitives }) });
  return builder.glb();
}

/** Mean luminance around the middle of the view. */
async function luminanceFrom(room: RoomDriver, camera: Camera): Promise<number> {
  const radiance = await room.evaluate((element, camera) => {
    element.camera = camera;
    element.step(0);
    return [...element.readRadiance(40, 70, 40, 20)];
  }, camera);
  let sum = 0;
  for (let i = 0; i < radiance.length; i += 3) {
    sum += luma([radiance[i] ?? 0, radiance[i + 1] ?? 0, radiance[i + 2] ?? 0]);
  }
  return sum / (radiance.length / 3);
}

test("Relief seen from behind is its own cast: bumps are dents", async ({ page }) => {
  test.slow(); // three renderers
  const room = new RoomDriver(page);
  await room.open({ look: "paper", quality: "medium" }, { ...SIZE, model: await panels() });
  for (const [look, quality] of [
    ["paper", "medium"],
    ["physical", "low"],
    ["physical", "medium"],
  ] as const) {
    await room.set({ quality });
    await room.change(look);
    const luminanceAt = (x: number) =>
      luminanceFrom(room, { position: [x, 1.4, 0.9], yaw: 0, pitch: 0 });
    const [back, front] = [await luminanceAt(-AWAY), await luminanceAt(AWAY)];
    expect(front).toBeGreaterThan(0);
    expect(back / front, `${look} at ${quality}`).toBeGreaterThan(0.9);
    expect(back / front, `${look} at ${quality}`).toBeLessThan(1.1);
  }
});

test("In the paper's look a smooth wall without a roughness map has a highlight, and a rough one none", async ({
  page,
}) => {
  const color = [0.3, 0.3, 0.3] as const;
  const walls = { "-z": { color, roughness: 0.2 } };
  const shell = {
    min: [-2, 0, -2],
    max: [2, 2.6, 2],
    material: { color },
    walls,
    isShell: true,
  } as const;
  const room = new RoomDriver(page);
  await room.open({ look: "paper" }, { ...SIZE, model: roomModel([shell]) });
  const luminanceAt = (yaw: number) =>
    luminanceFrom(room, { position: [0, 1.4, -1.2 * Math.cos(yaw)], yaw, pitch: 0 });
  const [smooth, rough] = [await luminanceAt(0), await luminanceAt(Math.PI)];
  expect(smooth / rough).toBeGreaterThan(1.1);
});

/** A floor whose threads are 6 mm wide and 2.5 texels: of woven cloth, from above. */
async function wovenFloor(): Promise<Buffer> {
  const builder = new GlbBuilder();
  const size = 64;
  const texels = Buffer.alloc(size * size * 3);
  for (let i = 0; i < size * size; i++) {
    // Slopes of one in one, along both axes.
    const [u, v] = [(i % size) * 0.4, Math.floor(i / size) * 0.4].map((turns) =>
      Math.sin(2 * Math.PI * turns),
    ) as [number, number];
    const length = Math.hypot(u, v, 1);
    texels.set(
      [u, v, 1].map((x) => Math.round(127.5 + (127.5 * x) / length)),
      i * 3,
    );
  }
  const raw = { width: size, height: size, channels: 3 } as const;
  const png = await sharp(texels, { raw }).png().toBuffer();
  const image = builder.add("images", { bufferView: builder.view(png), mimeType: "image/png" });
  const sampler = builder.add("samplers", { magFilter: 9729, minFilter: 9987 });
  const normalTexture = { index: builder.add("textures", { source: image, sampler }) };
  const material = builder.add("materials", {
    pbrMetallicRoughness: { metallicFactor: 0 },
    normalTexture,
  });
  const corners = [-4, 0, 4, 4, 0, 4, 4, 0, -4, -4, 0, -4];
  const repeats = 8 / (0.006 * (size / 2.5));
  const attributes = {
    POSITION: builder.accessor(Float32Array.from(corners), 3),
    NORMAL: builder.accessor(
      Float32Array.from({ length: 12 }, (_, i) => (i % 3) & 1),
      3,
    ),
    TANGENT: builder.accessor(
      Float32Array.from({ length: 16 }, (_, i) => Number(i % 4 === 0 || i % 4 === 3)),
      4,
    ),
    TEXCOORD_0: builder.accessor(
      Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1], (x) => x * repeats),
      2,
    ),
  };
  const indices = builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3), 1);
  const primitives = [{ attributes, indices, material }];
  builder.root({ mesh: builder.add("meshes", { primitives }) });
  return builder.glb();
}

test("Cloth of one thread a pixel is not peppered", async ({ page }) => {
  const room = new RoomDriver(page);
  await room.open({ look: "physical", quality: "high" }, { ...SIZE, model: await wovenFloor() });
  const contrast = await room.evaluate((element) => {
    element.camera = { position: [0, 0.9, 0], yaw: 0, pitch: -0.6 };
    element.step(0);
    const radiance = element.readRadiance(20, 20, 40, 40);
    const green = Array.from({ length: 1600 }, (_, i) => radiance[3 * i + 1] ?? 0);
    const steps = green.slice(1).map((here, i) => Math.abs(here - (green[i] ?? 0)));
    const sum = (values: number[]) => values.reduce((sum, value) => sum + value, 0);
    return sum(steps) / sum(green);
  });
  expect(contrast).toBeLessThan(0.07);
});

test("A mirror shows a plain wall without rings", async ({ page }) => {
  const material = { color: [0.5, 0.5, 0.5] } as const;
  const walls = { "-z": { color: [0.9, 0.9, 0.9], roughness: 0, metallic: 1 } } as const;
  const shell = { min: [-3, 0, -2], max: [3, 3, 3], material, walls, isShell: true } as const;
  const room = new RoomDriver(page);
  await room.open({ look: "physical", quality: "high" }, { ...SIZE, model: roomModel([shell]) });
  const steps = await room.evaluate((element) => {
    element.camera = { position: [0, 1.5, 0], yaw: 0, pitch: 0 };
    element.step(0);
    // Above the eye, between the mirrored corner and the flame's image.
    const radiance = element.readRadiance(16, 90, 44, 1);
    const green = Array.from({ length: 44 }, (_, i) => radiance[3 * i + 1] ?? 0);
    return green.slice(1).map((here, i) => Math.abs(here / (green[i] ?? 0) - 1));
  });
  expect(steps).toHaveLength(43);
  expect(Math.max(...steps)).toBeLessThan(0.04);
});

for (const quality of ["high", "low"] as const) {
  test(`At ${quality} a mirror shows the candle below its flame`, async ({ page }) => {
    const material = { color: [0.1, 0.1, 0.1] } as const;
    const walls = { "-z": { color: [0.9, 0.9, 0.9], roughness: 0, metallic: 1 } } as const;
    const shell = { min: [-3, 0, -2], max: [3, 3, 3], material, walls, isShell: true } as const;
    const room = new RoomDriver(page);
    await room.open({ look: "physical", quality }, { ...SIZE, model: roomModel([shell]) });
    const [bare, wax] = await room.evaluate((element) =>
      [false, true].map((candle) => {
        element.features = { candle };
        element.camera = { position: [0, 1.5, -1], yaw: 0, pitch: 0, fieldOfView: 1 };
        element.step(0);
        const [x = 0, y = 0, z = 0] = element.candles[0]?.position ?? [];
        // Four centimetres below the wick's foot, and mirrored behind z = -2.
        const offset = [x, 1.5 - y + 0.04].map((d) => d / (z + 3));
        const { width, height } = element.stats;
        const pixels = height / 2 / Math.tan(0.5);
        const [column = 0, row = 0] = [width / 2, height / 2].map((middle, i) =>
          Math.floor(middle + pixels * (offset[i] ?? 0)),
        );
        return element.readRadiance(column, row, 1, 1)[0] ?? 0;
      }),
    );
    expect(wax).toBeGreaterThan(2 * (bare ?? 0));
  });
}

test("At low a glossy floor has no stripes far from the flame", async ({ page }) => {
  const material = { color: [0.5, 0.5, 0.5] } as const;
  const walls = { "-y": { color: [0.2, 0.2, 0.2], roughness: 0.15 } } as const;
  const shell = { min: [-6, 0, -7], max: [6, 4, 7], material, walls, isShell: true } as const;
  const room = new RoomDriver(page);
  const model = roomModel([shell]);
  await room.open({ look: "physical", quality: "low" }, { width: 480, height: 270, model });
  const rows = await room.evaluate((element) => {
    element.camera = { position: [0, 1.6, 3], yaw: 0, pitch: 0 };
    element.step(0);
    const { width, height } = element.stats;
    // Of the floor 3 to 9 m ahead.
    return Array.from({ length: Math.floor(0.25 * height) }, (_, row) => {
      const y = Math.floor(0.68 * height) + row;
      return element.readRadiance(Math.floor(0.3 * width), y, 1, 1)[1] ?? 0;
    });
  });
  const bends = rows.slice(2).map((_, i) => {
    const [above = 0, here = 0, below = 0] = rows.slice(i, i + 3);
    return Math.abs(above + below - 2 * here) / here;
  });
  expect(Math.max(...bends)).toBeLessThan(0.05);
});

test("At low a dark ball mirrors the flame as bright wherever its texels are", async ({ page }) => {
  const material = { color: [0.02, 0.02, 0.02] } as const;
  const shell = { min: [-2, 0, -2], max: [2, 2.6, 2], material, isShell: true } as const;
  const glaze = { ...material, roughness: 0.05 } as const;
  const ball = { centre: [-0.25, 1.5, -0.8], radius: 0.15, material: glaze } as const;
  const room = new RoomDriver(page);
  await room.open(
    { look: "physical", quality: "low" },
    { ...SIZE, model: roomModel([shell, ball]) },
  );
  const sums = await room.evaluate((element) => {
    element.features = { indirect: false };
    return Array.from({ length: 12 }, (_, turn) => {
      element.camera = { position: [0, 1.5, 0], yaw: 0.004 * turn, pitch: 0 };
      element.step(0);
      const { width, height } = element.stats;
      const [columns, bottom, rows] = [0.45 * width, 0.25 * height, 0.45 * height];
      const box = [0, bottom, columns, rows].map(Math.round) as [number, number, number, number];
      return element.readRadiance(...box).reduce((sum, one) => sum + one);
    });
  });
  expect(Math.max(...sums) / Math.min(...sums)).toBeLessThan(1.2);
});

/** A screen between a wall and the room, of which a texture cuts out the right half. */
async function screen(): Promise<Buffer> {
  const builder = new GlbBuilder();
  const half = { width: 8, height: 16, channels: 4, background: "#fff" } as const;
  const bytes = await sharp({ create: half })
    .extend({ right: 8, background: { r: 255, g: 255, b: 255, alpha: 0 } })
    .png()
    .toBuffer();
  const image = builder.add("images", { bufferView: builder.view(bytes), mimeType: "image/png" });
  const baseColorTexture = { index: builder.add("textures", { source: image }) };
  const cut = builder.add("materials", {
    pbrMetallicRoughness: { baseColorTexture, metallicFactor: 0 },
    alphaMode: "MASK",
    doubleSided: true,
  });
  const plain = builder.add("materials", {
    pbrMetallicRoughness: { baseColorFactor: [0.3, 0.3, 0.3, 1], metallicFactor: 0 },
  });
  const square = (corners: readonly number[], material: number) => ({
    attributes: {
      POSITION: builder.accessor(Float32Array.from(corners), 3),
      TEXCOORD_0: builder.accessor(Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0), 2),
    },
    indices: builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3), 1),
    material,
  });
  const upright = (z: number, x: number, top: number) => [-x, 0, z, x, 0, z, x, top, z, -x, top, z];
  const primitives = [
    square([-4, 0, 4, 4, 0, 4, 4, 0, -4, -4, 0, -4], plain),
    square(upright(-2, 4, 2.6), plain),
    square(upright(-1, 1, 2), cut),
  ];
  builder.root({ mesh: builder.add("meshes", { primitives }) });
  return builder.glb();
}

for (const quality of ["low", "medium"] as const) {
  test(`At ${quality} what a mask cuts out lets light through, and the rest casts its shadow`, async ({
    page,
  }) => {
    const room = new RoomDriver(page);
    await room.open({ look: "physical", quality }, { ...SIZE, model: await screen() });
    const [left, right, sky] = await room.evaluate((element) => {
      element.camera = { position: [0, 1.6, 1], yaw: 0, pitch: -1 };
      element.place();
      if (element.held) throw new Error("The candle cannot be put down.");
      // Between the screen and the wall, which it looks at.
      element.camera = { position: [0, 1.6, -1.4], yaw: 0, pitch: -0.6 };
      element.step(0);
      const { width, height } = element.stats;
      const meanOf = (from: number) => {
        const radiance = element.readRadiance(
          Math.floor(from * width),
          Math.floor(0.3 * height),
          Math.floor(0.25 * width),
          Math.floor(0.4 * height),
        );
        return radiance.reduce((sum, value) => sum + value, 0) / radiance.length;
      };
      const sides = [meanOf(0.1), meanOf(0.65)];
      element.camera = { position: [0, 1.6, 1], yaw: Math.PI, pitch: 1 };
      element.step(0);
      return [...sides, element.readRadiance(0, 0, width, height).reduce((sum, x) => sum + x, 0)];
    });
    console.log(`${quality}: ${left} behind what is left, ${right} behind the hole`);
    expect(right).toBeGreaterThan(0);
    expect((left ?? 1) / (right ?? 0)).toBeLessThan(0.2);
    expect(sky, "where there is no surface").toBe(0);
    expect(room.complaints).toEqual([]);
  });
}
