import { expect, test } from "playwright/test";
import { packGlb } from "../../tools/models/glb-builder.mjs";
import { AnyRoom, edited, facings, fixtureUrl, verticesAt } from "../support/any-room.ts";
import type { Loaded, LoadedPart } from "../support/any-room-page.ts";
import { ORIGINS } from "../support/browser.ts";

/** 2 x 2 pixels of a fifth of the opacity. */
const CLEAR =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEUlEQVR42mP4//+/MQgzwBgAd5oMwQ8MwtsAAAAASUVORK5CYII=";

let room: AnyRoom;

test.beforeAll(async ({ browser }) => {
  room = await AnyRoom.open(await browser.newPage());
});
test.afterEach(() => room.expectTidy());
test.afterAll(() => room.page.close());

/** The sign of the fixtures: where it is, and which uv each corner has. */
const CORNERS: readonly (readonly [number[], number[]])[] = [
  [
    [0, 0, 0],
    [0, 1],
  ],
  [
    [2, 0, 0],
    [1, 1],
  ],
  [
    [2, 1, 0],
    [1, 0],
  ],
  [
    [0, 1, 0],
    [0, 0],
  ],
];
const RED = [255, 0, 0, 255];
const BLUE = [0, 0, 255, 255];

const closeTo = (values: readonly number[], tolerance: number) =>
  values.map((value) => expect.closeTo(value, -Math.log10(tolerance * 2)));

function only({ parts }: Loaded): LoadedPart {
  expect(parts).toHaveLength(1);
  return parts[0] as LoadedPart;
}

function named({ parts }: Loaded, name: string): LoadedPart {
  const part = parts.find((part) => part.name === name);
  if (!part) throw new Error(`no part ${name} among ${parts.map((part) => part.name)}`);
  return part;
}

function expectSign(part: LoadedPart, tolerance = 1e-3): void {
  expect(part.indices).toHaveLength(6);
  for (const facing of facings(part)) expect(facing).toEqual(closeTo([0, 0, 1], tolerance));
  for (const [place, uv] of CORNERS) {
    const [vertex] = verticesAt(part, place, tolerance);
    expect(vertex?.uv, `uv at ${place}`).toEqual(closeTo(uv, tolerance));
    expect(vertex?.normal).toEqual(closeTo([0, 0, 1], 0.02));
  }
}

test.describe("A visitor's file of each kind shows the same sign", () => {
  const KINDS: readonly { file: string; decoders?: RegExp; tolerance?: number; color?: number }[] =
    [
      { file: "plain.glb" },
      { file: "separate.gltf" },
      { file: "embedded.gltf" },
      { file: "sparse.glb" },
      { file: "quantized.glb" },
      { file: "meshopt.glb" },
      { file: "draco.glb", decoders: /^draco_/ },
      { file: "webp.glb" },
      { file: "avif.glb", color: 3 },
      { file: "ktx2-etc1s.glb", decoders: /^basis_/, color: 8 },
      { file: "ktx2-uastc.glb", decoders: /^basis_/, color: 8 },
    ];
  for (const { file, decoders, tolerance = 1e-3, color = 0 } of KINDS) {
    test(`${file} stands at its place, with its picture the right way round`, async () => {
      const before = room.decoders.length;
      const model = await room.load(fixtureUrl(file));
      const part = only(model);
      expectSign(part, tolerance);
      const { albedo, roughness, metallic } = part.material;
      for (const [side, expected] of [
        [albedo?.left, RED],
        [albedo?.right, BLUE],
      ] as const) {
        const error = expected.map((value, k) => Math.abs(value - (side?.[k] ?? -1)));
        expect(Math.max(...error), `${side} for ${expected}`).toBeLessThanOrEqual(color);
      }
      expect([roughness, metallic]).toEqual([0.75, 0]);
      expect(model.bounds.max).toEqual(closeTo([2, 1, 0], tolerance));
      expect(model.warnings).toEqual([]);
      expect(model.shares.at(-1)).toBe(1);
      const fetched = room.decoders.slice(before);
      expect(fetched.length).toBe(decoders ? 2 : 0);
      for (const name of fetched) expect(name).toMatch(decoders ?? /^$/);
    });
  }

  test("a KTX2 picture comes as plain pixels, any other as a bitmap", async () => {
    const compressed = only(await room.load(fixtureUrl("ktx2-uastc.glb"))).material.albedo;
    expect(compressed).toMatchObject({ kind: "pixels", width: 8, height: 8 });
    const png = only(await room.load(fixtureUrl("plain.glb"))).material.albedo;
    expect(png).toMatchObject({ kind: "bitmap", width: 8, height: 8 });
  });

  test("a picture that the browser cannot decode gives way to the fallback beside it", async () => {
    const body = edited("plain.glb", (json) => {
      json.images.push({ uri: "missing.avif" });
      json.textures[0].extensions = { EXT_texture_avif: { source: 1 } };
      json.extensionsUsed = ["EXT_texture_avif"];
    });
    await room.serve("missing.avif", { body: "", status: 404 });
    const model = await room.load(await room.serve("fallback.glb", { body }));
    expect(only(model).material.albedo?.left).toEqual(RED);
  });
});

test.describe("What a surface is made of survives", () => {
  test("colours of vertices, however they are stored, are linear and of four numbers", async () => {
    const model = await room.load(fixtureUrl("colors.glb"));
    for (const [name, opacity] of [
      ["rgb bytes", 1],
      ["rgba shorts", 0.8],
      ["rgb floats", 1],
      ["forgotten flag", 0.8],
    ] as const) {
      const part = named(model, name);
      const color = (place: number[]) => verticesAt(part, place)[0]?.color;
      expect(color([0, 0, 0]), name).toEqual([1, 0, 0, 1]);
      expect(color([2, 0, 0]), name).toEqual([0, 1, 0, 1]);
      expect(color([0, 1, 0]), name).toEqual(closeTo([0.2, 0.4, 0.6, opacity], 2e-5));
    }
  });

  test("a second set of uv carries the colour, and maps by the first are left out", async () => {
    const model = await room.load(fixtureUrl("uv-sets.glb"));
    const part = only(model);
    expect(part.uvs).toEqual([0.25, 0.75, 0.75, 0.75, 0.75, 0.25, 0.25, 0.25]);
    expect(part.material.occlusionStrength).toBe(0);
    expect(part.material.normal).toBeNull();
    expect(model.warnings).toEqual([
      'The normal map of material "two sets" lies otherwise than its colour and is left out.',
    ]);
  });

  test("a texture's turn, scale and offset are in its uv", async () => {
    const part = only(await room.load(fixtureUrl("texture-transform.glb")));
    // offset + rotation by a quarter turn of (2 u, 3 v), as KHR_texture_transform has it
    for (const [place, [u = 0, v = 0]] of CORNERS) {
      const [vertex] = verticesAt(part, place);
      expect(vertex?.uv).toEqual(closeTo([0.25 + 3 * v, 0.5 - 2 * u], 1e-5));
    }
  });

  test("transparency, doubled sides and strengths of maps are reported", async () => {
    const model = await room.load(fixtureUrl("materials.glb"));
    const material = (name: string) => named(model, name).material;
    expect(material("glass")).toMatchObject({ alphaMode: "blend", isDoubleSided: false });
    expect(material("glass").baseColor).toEqual(closeTo([0.5, 0.6, 0.7, 0.25], 1e-6));
    expect(material("glass").mapOpacity).toBe(1);
    expect(material("leaf")).toMatchObject({
      alphaMode: "mask",
      alphaCutoff: 0.3,
      isDoubleSided: true,
    });
    expect(material("packed")).toMatchObject({ normalScale: 0.5, occlusionStrength: 0.25 });
    expect(material("packed").occlusionRoughnessMetallic?.left).toEqual(RED);
    expect(material("apart").occlusionStrength).toBe(0);
    expect(material("glossy")).toMatchObject({ roughness: 0.75, metallic: 0 });
    expect(material("glossy").baseColor).toEqual([0.1, 0.2, 0.3, 1]);
  });

  test("the opacity of what is mixed is the mean of its map", async () => {
    const body = edited("plain.glb", (json) => {
      json.images = [{ uri: CLEAR }];
      json.materials[0].alphaMode = "BLEND";
    });
    const { material } = only(await room.load(await room.serve("clear.glb", { body })));
    expect(material.mapOpacity).toBeCloseTo(0.2, 2);
  });

  test("what cannot be had is named in one warning of the console", async () => {
    const before = room.console.length;
    const { warnings } = await room.load(fixtureUrl("materials.glb"));
    const messages = room.console.slice(before).filter(({ type }) => type === "warning");
    expect(messages).toEqual([{ type: "warning", text: `materials.glb: ${warnings.join(" ")}` }]);
    expect(warnings).toEqual([
      "KHR_materials_transmission is not supported: what should be clear is as opaque as its alpha says.",
      "KHR_materials_unlit is not supported: unlit surfaces are lit like all others.",
      "KHR_materials_pbrSpecularGlossiness is not supported: diffuse colour is kept, and glossiness that has no map, specular is not.",
      "KHR_lights_punctual is not supported: its lights stay out, the flame is the only one.",
      "EXAMPLE_of_tomorrow is not supported: it is ignored.",
      "Materials that glow do not: the flame is the only light.",
    ]);
  });
});

test.describe("Geometry stands where its file puts it", () => {
  test("a mirrored and stretched sign faces the way its normals do", async () => {
    const part = named(await room.load(fixtureUrl("transforms.glb")), "mirrored");
    // Turned to the left, its x runs along -Z; mirrored, along +Z again; 3 times as wide, 2 as high.
    const [corner] = verticesAt(part, [10, 2, 6]);
    expect(corner?.uv).toEqual([1, 0]);
    expect(corner?.normal).toEqual(closeTo([1, 0, 0], 1e-6));
    expect(corner?.tangent).toEqual(closeTo([0, 0, 1, -1], 1e-6));
    for (const facing of facings(part)) expect(facing).toEqual(closeTo([1, 0, 0], 1e-6));
  });

  test("a slope that is stretched has the normal of the new slope", async () => {
    const part = named(await room.load(fixtureUrl("transforms.glb")), "slope");
    const [facing = []] = facings(part);
    expect(facing).toEqual(closeTo([1 / Math.sqrt(5), 2 / Math.sqrt(5), 0], 1e-6));
    expect(verticesAt(part, [2, -1, 0])[0]?.normal).toEqual(closeTo(facing, 1e-6));
  });

  test("instances are all there, each with its own scale, in one part", async () => {
    const part = only(await room.load(fixtureUrl("instances.glb")));
    expect(part.indices).toHaveLength(18);
    expect(verticesAt(part, [2, 2, 0])).toHaveLength(1);
    expect(verticesAt(part, [9, 3, 0])).toHaveLength(1);
    expect(verticesAt(part, [-2, 2, 7])[0]?.tangent).toEqual(closeTo([-1, 0, 0, -1], 1e-6));
    for (const facing of facings(part)) expect(facing).toEqual(closeTo([0, 0, 1], 1e-6));
  });

  test("strips, fans and loose triangles face the eye; lines and points are left out", async () => {
    const model = await room.load(fixtureUrl("primitives.glb"));
    expect(model.parts.map(({ name }) => name)).toEqual(["strip", "fan", "loose"]);
    for (const part of model.parts) {
      expect(part.indices, part.name).toHaveLength(6);
      expect(facings(part), part.name).toEqual([
        [0, 0, 1],
        [0, 0, 1],
      ]);
      for (const [place] of CORNERS) expect(verticesAt(part, place).length).toBeGreaterThan(0);
    }
    expect(model.anchors).toEqual({});
    expect(model.warnings).toEqual(["Lines and points are not drawn."]);
  });

  test("positions alone get flat normals, tangents across them, and a plain material", async () => {
    const part = only(await room.load(fixtureUrl("bare.glb")));
    const normals = verticesAt(part, [0, 1, 0]).map(({ normal }) => normal.map(Math.round));
    expect(normals).toContainEqual([0, 0, 1]);
    expect(normals).toContainEqual([-1, 0, 0]);
    for (const { normal, tangent } of verticesAt(part, [0, 0, 0])) {
      const [x = 0, y = 0, z = 0] = tangent;
      expect(Math.hypot(x, y, z)).toBeCloseTo(1, 6);
      expect(normal.reduce((sum, n, k) => sum + n * (tangent[k] ?? 0), 0)).toBeCloseTo(0, 6);
    }
    expect(part.uvs.every((value) => value === 0)).toBe(true);
    expect(part.material).toMatchObject({ metallic: 0, roughness: 1, baseColor: [1, 1, 1, 1] });
  });

  test("tangents that a file leaves out are those it would have had", async () => {
    const url = await room.serve("no-tangents.glb", {
      body: edited("plain.glb", (json) => {
        delete json.meshes[0].primitives[0].attributes.TANGENT;
        json.materials[0].normalTexture = { index: 0 };
      }),
    });
    const [vertex] = verticesAt(only(await room.load(url)), [2, 1, 0]);
    expect(vertex?.tangent).toEqual(closeTo([1, 0, 0, 1], 1e-6));
  });

  test("bones and morph targets hold their rest pose", async () => {
    const model = await room.load(fixtureUrl("posed.glb"));
    const skinned = named(model, "skinned");
    expect(verticesAt(skinned, [2, 2, 0])[0]?.uv).toEqual([1, 1]);
    expect(verticesAt(skinned, [2, 3, 1.5])[0]?.uv).toEqual([1, 0]);
    expect(verticesAt(named(model, "morphed"), [4, 1, 0])[0]?.uv).toEqual([1, 0]);
  });

  test("of several scenes the preferred one is shown", async () => {
    const model = await room.load(fixtureUrl("scenes.glb"));
    expect(only(model).name).toBe("other");
    expect(model.bounds).toEqual({ min: [0, 3, 0], max: [2, 4, 0] });
    expect(model.warnings).toEqual(["Of its 2 scenes one is shown."]);
  });

  test("textures of hidden scenes are not fetched", async () => {
    const body = edited("scenes.glb", ({ nodes, meshes, materials, textures, images }) => {
      images.push({ uri: "gone.png" });
      textures.push({ source: 1 });
      materials.push({ pbrMetallicRoughness: { baseColorTexture: { index: 1 } } });
      meshes.push({ primitives: [{ ...meshes[0].primitives[0], material: 1 }] });
      nodes[0].mesh = 1;
    });
    expect(only(await room.load(await room.serve("scenes.glb", { body }))).name).toBe("other");
  });

  test("a named empty node is a place, and a way to look", async () => {
    const { anchors } = await room.load(fixtureUrl("plain.glb"));
    expect(Object.keys(anchors)).toEqual(["spawn"]);
    expect(anchors.spawn?.position).toEqual([1, 0, 2]);
    expect(anchors.spawn?.yaw).toBeCloseTo(Math.PI / 2, 6);
  });

  test("metals and what is smooth are glossy, by their maps", async () => {
    const glossy = await room.glossyMaterials(`${ORIGINS.sources}models/cabin.glb`);
    expect(glossy).toEqual(["brass", "glass", "iron", "looking-glass", "pane", "pewter", "pool"]);
  });

  test("an element that the last stride cuts off is read all the same", async () => {
    const interleaved = Buffer.from(
      Float32Array.from([0, 0, 0, 9, 2, 0, 0, 9, 0, 2, 0]).buffer, // no fourth number at the end
    );
    const json = {
      asset: { version: "2.0" },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, type: "VEC3", count: 3 }],
      bufferViews: [{ buffer: 0, byteLength: 44, byteStride: 16 }],
      buffers: [{ byteLength: 44 }],
    };
    const url = await room.serve("stride.glb", { body: packGlb(json, interleaved) });
    expect(only(await room.load(url)).positions).toEqual([0, 0, 0, 2, 0, 0, 0, 2, 0]);
  });
});
