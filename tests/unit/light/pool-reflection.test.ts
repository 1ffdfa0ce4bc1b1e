import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { vec3 } from "gl-matrix";
import sharp from "sharp";
import { expect, test } from "vitest";
import { luma, type Rgb } from "../../../src/light/color.ts";
import { flameLight, TAPER } from "../../../src/light/flame-light.ts";
import { TAPER_WICK } from "../../../src/world/flame/burning.ts";
import { Flame } from "../../../src/world/flame/flame.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { openGlb } from "../../../tools/models/glb-builder.mjs";
import { textOf } from "../sources.js";

const MODELS = new URL("../../../public/models/", import.meta.url);
/** Wax within this distance of the flame's middle lies open to it, metres. */
const DISH = 0.03;
const LAMPS = 6;

const { json, binary } = openGlb(readFileSync(new URL("chamberstick.glb", MODELS)));
const root = json.nodes.find(({ name }: { name: string }) => name === "flame").translation;
const still = { root, flame: new Flame(TAPER_WICK, true) } as const;
const { position: middle, intensity, halfHeight } = flameLight(still, TAPER);

interface Triangle {
  readonly at: Vec3;
  readonly sides: readonly [vec3, vec3];
  readonly corner: vec3;
  readonly normal: vec3;
  readonly area: number;
  readonly material: string;
}

function numbers(index: number): ArrayLike<number> {
  const { bufferView, byteOffset = 0, componentType, count, type } = json.accessors[index];
  const { byteOffset: start = 0 } = json.bufferViews[bufferView];
  const Kind = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }[
    componentType as 5123 | 5125 | 5126
  ];
  const bytes = Uint8Array.from(binary.subarray(start + byteOffset));
  return new Kind(bytes.buffer, 0, count * (type === "VEC3" ? 3 : 1));
}

/** Around the flame's foot: pool, dish and wick. The nodes of this model are not moved. */
function trianglesNearby(): Triangle[] {
  const found: Triangle[] = [];
  for (const { primitives } of json.meshes) {
    for (const { attributes, indices, material } of primitives) {
      const [positions, order] = [numbers(attributes.POSITION), numbers(indices)];
      const cornerAt = (k: number) =>
        vec3.fromValues(
          ...([0, 1, 2].map((axis) => positions[3 * (order[k] ?? 0) + axis] ?? 0) as Vec3),
        );
      for (let k = 0; k < order.length; k += 3) {
        const [a, b, c] = [cornerAt(k), cornerAt(k + 1), cornerAt(k + 2)];
        const sides = [vec3.sub(vec3.create(), b, a), vec3.sub(vec3.create(), c, a)] as const;
        const normal = vec3.cross(vec3.create(), ...sides);
        const area = vec3.length(normal) / 2;
        const sum = vec3.add(vec3.create(), vec3.add(vec3.create(), a, b), c);
        const [x, y, z] = vec3.scale(vec3.create(), sum, 1 / 3);
        const at: Vec3 = [x ?? 0, y ?? 0, z ?? 0];
        if (area < 1e-14 || vec3.distance(at, middle) > DISH) continue;
        vec3.normalize(normal, normal);
        const { name } = json.materials[material];
        found.push({ at, sides, corner: a, normal, area, material: name });
      }
    }
  }
  return found;
}

const [across, offset, turned] = [vec3.create(), vec3.create(), vec3.create()];
/** Whether a triangle lies between two points (Möller and Trumbore 1997, "Fast, Minimum Storage Ray-Triangle Intersection"). */
function lies({ corner, sides: [u, v] }: Triangle, from: Vec3, way: vec3): boolean {
  vec3.cross(across, way, v);
  const determinant = vec3.dot(u, across);
  vec3.sub(offset, from, corner);
  const first = vec3.dot(offset, across) / determinant;
  if (first < 0 || first > 1) return false;
  vec3.cross(turned, offset, u);
  const second = vec3.dot(way, turned) / determinant;
  const distance = vec3.dot(v, turned) / determinant;
  return second >= 0 && first + second <= 1 && distance > 1e-3 && distance < 1;
}

test("the pool in its dish of wax reflects straight up what the flame sheds on them", async () => {
  const surface = (wanted: string) =>
    json.materials.find(({ name }: { name: string }) => name === wanted).pbrMetallicRoughness;
  const albedo = ([red, green, blue]: Rgb) =>
    luma([intensity[0] * red, intensity[1] * green, intensity[2] * blue]) / luma(intensity);
  const texture = json.textures[surface("wax").baseColorTexture.index];
  const { uri } = json.images[texture.extensions.EXT_texture_avif.source];
  const { channels } = await sharp(fileURLToPath(new URL(uri, MODELS))).stats();
  const [red = 0, green = 0, blue = 0] = channels.map(({ mean }) => (mean / 255) ** 2.2);
  const [r, g, b] = surface("pool").baseColorFactor;
  const albedos: Record<string, number> = {
    pool: albedo([r, g, b]),
    wax: albedo([red, green, blue]),
  };
  const triangles = trianglesNearby();
  let intensityUp = 0;
  for (const { at, normal, area, material } of triangles) {
    const up = Math.max(normal[1] ?? 0, 0) * area * (albedos[material] ?? 0);
    if (up === 0) continue;
    const above = triangles.filter((other) => other.at[1] > at[1] - 1e-3);
    for (let i = 0; i < LAMPS; i++) {
      const height = ((i + 0.5) / LAMPS) * 2 - 1;
      const way = vec3.sub(vec3.create(), middle, at);
      way[1] = (way[1] ?? 0) + height * halfHeight;
      const distance = vec3.length(way);
      const cosine = vec3.dot(way, normal) / distance;
      if (cosine <= 0 || above.some((other) => lies(other, at, way))) continue;
      intensityUp += ((up / Math.PI) * cosine) / distance ** 2 / LAMPS;
    }
  }
  const [, share] =
    /POOL_REFLECTANCE = ([\d.]+)/.exec(textOf("shaders/lib/pool-reflection.glsl")) ?? [];
  expect(Math.abs(Number(share) - intensityUp)).toBeLessThan(0.015);
});
