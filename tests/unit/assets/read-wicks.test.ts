import { Object3D } from "three";
import { describe, expect, test } from "vitest";
import { readDocument } from "../../../src/assets/gltf-document.ts";
import { readWicks, wickEnding } from "../../../src/assets/read-wicks.ts";

interface Given {
  readonly name: string;
  readonly position?: readonly [number, number, number];
  readonly wickDiameter?: unknown;
  readonly turn?: number;
  readonly scale?: number;
  readonly isMisplaced?: boolean;
}

/** The wicks of a scene of these nodes, and what is said about them. */
function read(nodes: readonly Given[], unit = 1) {
  const scene = new Object3D();
  scene.scale.setScalar(unit);
  for (const [order, given] of nodes.entries()) {
    const { name, position = [0, 1, 0], wickDiameter, turn = 0, scale = 1 } = given;
    const node = new Object3D();
    node.userData = { name, order, wickDiameter, isMisplaced: given.isMisplaced };
    node.position.set(...position);
    node.rotation.z = turn;
    node.scale.setScalar(scale);
    scene.add(node);
  }
  scene.updateMatrixWorld(true);
  const warnings = new Set<string>();
  const wicks = readWicks(scene, warnings);
  return { wicks, warnings: [...warnings] };
}

const DIAMETERS = "Wick diameters are 1 to 50 mm: what is no number is 2 mm, all else the nearest.";

describe("wicks of a model", () => {
  test("of one name are numbered, and each has the flame beside it", () => {
    const scene = new Object3D();
    for (const [i, x] of [0, 5].entries()) {
      const candle = new Object3D();
      for (const [name, y] of [
        ["wick", 1],
        ["flame", 2],
      ] as const) {
        const node = new Object3D();
        node.userData = { name, order: i };
        node.position.set(x, y, 0);
        candle.add(node);
      }
      scene.add(candle);
    }
    scene.updateMatrixWorld(true);
    const warnings = new Set<string>();
    const wicks = readWicks(scene, warnings);
    expect(wicks.map(({ name, position }) => [name, ...position])).toEqual([
      ["wick", 0, 2, 0],
      ["wick#2", 5, 2, 0],
    ]);
    expect([...warnings]).toEqual(["Wicks of one name are numbered."]);
  });

  test("have a name each, whatever the file's are", () => {
    const { wicks } = read(["wick", "wick", "wick#2", "wick"].map((name) => ({ name })));
    expect(wicks.map(({ name }) => name)).toEqual(["wick", "wick#2", "wick#2#2", "wick#3"]);
  });

  test("are its nodes named wick, with any suffix that does not continue the word", () => {
    expect(["wick", "wick.001", "wick-left", "wick_2", "wickLeft"].map(wickEnding)).toEqual([
      "",
      ".001",
      "-left",
      "_2",
      "Left",
    ]);
    expect(["wicker", "wicked chair", "candlewick", "Flame"].map(wickEnding)).toEqual([
      undefined,
      undefined,
      undefined,
      undefined,
    ]);
  });

  test("have their flame's root at their origin, or at that of the flame of the same ending", () => {
    const { wicks, warnings } = read([
      { name: "wick", position: [1, 2, 3] },
      { name: "wick.001", position: [4, 5, 6], wickDiameter: 3 },
      { name: "flame.001", position: [4, 5.01, 6] },
      { name: "flame.002", position: [9, 9, 9] },
    ]);
    expect(wicks).toEqual([
      { name: "wick", position: [1, 2, 3], wickDiameter: 0.002 },
      { name: "wick.001", position: [4, 5.01, 6], wickDiameter: 0.003 },
    ]);
    expect(warnings).toEqual([]);
  });

  test("beyond sixteen do not burn", () => {
    const { wicks, warnings } = read(
      Array.from({ length: 100 }, (_, i) => ({ name: `wick.${i}`, position: [i, 1, 0] as const })),
    );
    expect(wicks).toHaveLength(16);
    expect(wicks[15]?.name).toBe("wick.15");
    expect(warnings).toEqual(["Of its 100 wicks 16 burn."]);
  });

  test.each<[string, Partial<Given>, string]>([
    ["upside down", { turn: Math.PI }, "Wicks that lean by more than 45 degrees burn upright."],
    ["lying", { turn: 1.5 }, "Wicks that lean by more than 45 degrees burn upright."],
    [
      "scaled by 1000",
      { scale: 1000 },
      "The scale of a wick is ignored: its diameter is wickDiameter, in mm.",
    ],
    ["too wide", { wickDiameter: 2000 }, DIAMETERS],
    ["of no number", { wickDiameter: "NaN" }, DIAMETERS],
    ["of null", { wickDiameter: null }, DIAMETERS],
  ])("%s burn all the same", (_, given, warning) => {
    const { wicks, warnings } = read([
      { name: "wick", ...given },
      { name: "wick.001", ...given },
    ]);
    expect(wicks).toHaveLength(2);
    expect(wicks[0]?.wickDiameter).toBe(given.wickDiameter === 2000 ? 0.05 : 0.002);
    expect(warnings).toEqual([warning]);
  });

  test("of a model in centimetres or millimetres are not scaled themselves", () => {
    for (const unit of [0.01, 0.001]) {
      const { wicks, warnings } = read([{ name: "wick" }], unit);
      expect(wicks).toMatchObject([{ position: [0, unit, 0], wickDiameter: 0.002 }]);
      expect(warnings).toEqual([]);
    }
  });

  test("are left out where their position is not finite", () => {
    const { wicks, warnings } = read([
      { name: "wick", isMisplaced: true },
      { name: "wick.001", position: [1e300, 1, 0] },
      { name: "wick.002" },
    ]);
    expect(wicks.map(({ name }) => name)).toEqual(["wick.002"]);
    expect(warnings).toEqual(["Wicks whose places are no numbers are left out."]);
  });
});

test("a document with a wick in no place is read, and one with another such node is not", () => {
  const document = (name: string, mesh?: number) => ({
    asset: { version: "2" },
    accessors: [{ componentType: 5126, type: "VEC3", count: 3 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    nodes: [{ name, mesh, translation: [null, 0, 0], extras: { wickDiameter: [] } }],
  });
  for (const mesh of [undefined, 0]) {
    const [wick] = readDocument(document("wick", mesh)).nodes;
    expect(wick).toMatchObject({ isMisplaced: true, wickDiameter: [] });
    expect([wick?.translation, wick?.mesh]).toEqual([undefined, undefined]);
  }
  for (const other of [document("chair"), document("flamethrower", 0)]) {
    expect(() => readDocument(other)).toThrow("holds what is not a number");
  }
});
