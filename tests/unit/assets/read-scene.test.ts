import { expect, test } from "vitest";
import type { Decoders } from "../../../src/assets/decoders.ts";
import { readDocument } from "../../../src/assets/gltf-document.ts";
import { readScene } from "../../../src/assets/read-scene.ts";
import { buildScene } from "../../../src/assets/three-scene.ts";

const CORNERS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9];
const VALUES = Float32Array.from([
  ...CORNERS,
  ...[0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  ...[0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0],
  ...[0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0],
]);
const INDICES = Uint8Array.from([0, 1, 2]);

/** Four vertices, of which a triangle uses three; normals and offsets of both are accessors 1 to 3. */
const accessor = (bufferView: number) => ({
  bufferView,
  componentType: 5126,
  type: "VEC3",
  count: 4,
  min: [0, 0, 0],
  max: [9, 9, 9],
});
const FILE = {
  asset: { version: "2.0" },
  buffers: [{ byteLength: 195 }],
  bufferViews: [
    ...[0, 48, 96, 144].map((byteOffset) => ({ buffer: 0, byteOffset, byteLength: 48 })),
    { buffer: 0, byteOffset: 192, byteLength: 3 },
  ],
  accessors: [
    ...[0, 1, 2, 3].map(accessor),
    { bufferView: 4, componentType: 5121, type: "SCALAR", count: 3 },
  ],
};
const TRIANGLE = { attributes: { POSITION: 0, NORMAL: 1 }, indices: 4 };

async function read(file: object, isCandle = false, warnings = new Set<string>()) {
  const document = readDocument({ ...FILE, ...file });
  const bytes = new Uint8Array([...new Uint8Array(VALUES.buffer), ...INDICES]);
  const readView = async (index: number) => bytes.slice(index * 48, index * 48 + 48);
  const scene = await buildScene(document, readView as never, {} as Decoders);
  return readScene(scene, new Map(), warnings, isCandle);
}

test("vertices that no triangle uses are left out", async () => {
  const reduced = { ...TRIANGLE, extras: { reducedIndices: 4 } };
  for (const primitive of [TRIANGLE, reduced]) {
    const meshes = [{ primitives: [primitive, primitive] }];
    const { parts } = await read({ nodes: [{ mesh: 0 }], meshes });
    expect(parts).toHaveLength(2);
    for (const { positions, indices, reducedIndices } of parts) {
      expect([...positions]).toEqual(CORNERS.slice(0, 9));
      expect([...indices]).toEqual([0, 1, 2]);
      expect(reducedIndices).toBeUndefined();
    }
  }
});

test("candles alone that are too large for metres are read in centimetres, with a warning", async () => {
  const meshes = [{ primitives: [TRIANGLE] }];
  const wick = { name: "wick", translation: [1, 0, 0] };
  const file = (size: number) => ({
    nodes: [{ scale: [size, size, size], children: [1, 2] }, { mesh: 0 }, wick],
    scenes: [{ nodes: [0] }],
    meshes,
  });
  const warnings = new Set<string>();
  const { parts, wicks, bounds } = await read(file(20), true, warnings);
  expect(parts[0]?.positions[3]).toBeCloseTo(0.2, 6);
  expect(wicks[0]?.position[0]).toBeCloseTo(0.2, 6);
  expect(bounds.max[1]).toBeCloseTo(0.2, 6);
  expect([...warnings]).toEqual(["A candle of 20.0 m is read as one in centimetres."]);
  expect((await read(file(20))).bounds.max[0]).toBe(20);
  expect((await read(file(2000), true)).bounds.max[0]).toBeCloseTo(2, 6);
});

test("of rooms of more than 60 m a warning says that what is far is not drawn", async () => {
  for (const [scale, sentences] of [
    [60, 0],
    [61, 1],
  ] as const) {
    const warnings = new Set<string>();
    const nodes = [{ mesh: 0, scale: [scale, 1, 1] }];
    await read({ nodes, meshes: [{ primitives: [TRIANGLE] }] }, false, warnings);
    expect(warnings.size).toBe(sentences);
  }
});

test("one vertex buffer of many primitives counts as what they use of it, and only where shown", () => {
  const accessors = FILE.accessors.map((one, i) =>
    i < 4 ? { ...one, bufferView: undefined, count: 1e6 } : one,
  );
  const primitives = Array.from({ length: 20 }, () => TRIANGLE);
  const meshes = [{ primitives }, { primitives: [{ attributes: { POSITION: 0 } }] }];
  const nodes = Array.from({ length: 20 }, (_, i) => ({ mesh: i > 0 ? 1 : 0 }));
  const scenes = [{ nodes: [0] }, { nodes: [1] }];
  expect(readDocument({ ...FILE, accessors, meshes, nodes, scenes }).shown).toEqual([0]);
});

test("a small file cannot ask for much memory", async () => {
  const zeros = (type: string, count: number) => ({ componentType: 5126, type, count });
  const accessors = [...FILE.accessors, zeros("MAT4", 15e6)];
  const skinned = {
    accessors,
    nodes: [{ mesh: 0, skin: 0 }],
    skins: [{ joints: [0], inverseBindMatrices: 5 }],
    meshes: [{ primitives: [TRIANGLE] }],
  };
  await expect(read(skinned)).rejects.toThrow("has geometry of more than 512 MB");
  const meshopt = { count: 1e6, byteStride: 128, mode: "ATTRIBUTES", buffer: 0 };
  const view = { extensions: { EXT_meshopt_compression: meshopt } };
  const bufferViews = [...FILE.bufferViews, ...Array.from({ length: 5 }, () => view)];
  await expect(read({ bufferViews })).rejects.toThrow(
    "bufferViews[9].extensions.EXT_meshopt_compression.count is too large",
  );
});

test("morph targets move positions and normals, also beside one of normals alone", async () => {
  const morphed = { ...TRIANGLE, targets: [{ NORMAL: 3 }, { POSITION: 2 }] };
  const meshes = [{ primitives: [morphed], weights: [1, 0.5] }];
  const { parts } = await read({ nodes: [{ mesh: 0 }], meshes });
  expect([...(parts[0]?.positions ?? [])]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0.5]);
  const half = Math.fround(Math.SQRT1_2);
  expect([...(parts[0]?.normals ?? [])]).toEqual([0, half, half, 0, half, half, 0, half, half]);
});

test("instances of a morphed mesh have its rest pose, or their node's", async () => {
  const morphed = { ...TRIANGLE, targets: [{ POSITION: 2 }] };
  const attributes = { TRANSLATION: 1 };
  const instanced = { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes } } };
  for (const primitives of [[morphed], [morphed, morphed]]) {
    const nodes = [instanced, { ...instanced, weights: [0.25] }];
    const { parts } = await read({ nodes, meshes: [{ primitives, weights: [0.5] }] });
    const heights = parts.map(({ positions }) => positions[8]);
    expect(heights).toEqual(primitives.map(() => 1.5).concat(primitives.map(() => 1.25)));
  }
});

test("missing normals are those of the morphed triangles", async () => {
  const morphed = { ...TRIANGLE, attributes: { POSITION: 0 }, targets: [{ POSITION: 2 }] };
  const meshes = [{ primitives: [morphed], weights: [1] }];
  const { parts } = await read({ nodes: [{ mesh: 0 }], meshes });
  const half = Math.fround(Math.SQRT1_2);
  for (const [i, x] of [0, -half, half].entries()) expect(parts[0]?.normals[i]).toBeCloseTo(x, 6);
});

test("one axis of scale 0 keeps the normals, and a matrix of it its size", async () => {
  const meshes = [{ primitives: [TRIANGLE] }];
  const flat = { mesh: 0, matrix: [2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 5, 1] };
  const none = { mesh: 0, matrix: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1] };
  const { parts } = await read({ nodes: [flat, none], meshes });
  expect([...(parts[0]?.positions ?? [])]).toEqual([0, 0, 5, 2, 0, 5, 0, 3, 5]);
  expect([...(parts[0]?.normals ?? [])]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  expect(parts[1]?.positions.every((x) => x === 0)).toBe(true);
});

test("a moon of scale 0 has a direction", async () => {
  const nodes = [{ mesh: 0 }, { name: "moon", scale: [0, 0, 0] }, { name: "else" }];
  const { anchors } = await read({ nodes, meshes: [{ primitives: [TRIANGLE] }] });
  expect(anchors).toMatchObject({ moon: { forward: [0, 0, -1] } });
  expect(Object.keys(anchors)).toEqual(["moon"]);
});

test("a moon of a huge or a tiny scale shines where it is turned to", async () => {
  for (const scale of [1e200, 1e-200]) {
    const moon = { name: "moon", rotation: [-1, 0, 0, 1], scale: [scale, scale, scale] };
    const { anchors } = await read({
      nodes: [{ mesh: 0 }, moon],
      meshes: [{ primitives: [TRIANGLE] }],
    });
    expect(anchors.moon?.forward[1]).toBeCloseTo(-1, 6);
  }
});
