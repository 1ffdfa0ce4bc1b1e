import smokeFrag from "../../../shaders/volumetric/smoke.frag";
import smokeVert from "../../../shaders/volumetric/smoke.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { LINES, ROWS, SMOKE_FLOATS, type Smoke } from "../../world/particles/smoke.js";
import type { IrradianceVolume } from "../gi/indirect-pass.js";
import type { Sphere } from "../screen-bounds.js";
import type { VolumetricTarget } from "./volumetric-target.js";

/** Half width of a ribbon, in standard deviations: `REACH` of the shader. */
const REACH = 2.4;

/** Smoke of the wick: streaklines of droplets that scatter the room's light. */
export class SmokePass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #parcels: Texture;
  readonly #ribbons: VertexArray;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#program = gpu.program("volumetric/smoke", smokeVert, smokeFrag, {
      defines: { LINES, ROWS },
    });
    this.#parcels = gpu.texture({
      label: "smoke/parcels",
      format: "RGBA32F",
      source: { width: (LINES * SMOKE_FLOATS) / 4, height: ROWS },
      filter: "nearest",
    });
    const indices = ribbonIndices();
    this.#ribbons = gpu.vertexArray("smoke/ribbons", {
      attributes: {},
      indices: { buffer: gpu.buffer("smoke/indices", indices, "index"), type: "uint16" },
      count: indices.length,
    });
  }

  /** Blends the smoke over the target. */
  render(
    { target, depth }: VolumetricTarget,
    smoke: Smoke,
    frame: UniformBlock,
    light: UniformBlock,
    volume: IrradianceVolume,
  ): void {
    if (smoke.count < 2) return;
    this.#parcels.update(smoke.parcels);
    this.#gpu.draw({
      program: this.#program,
      target,
      vertexArray: this.#ribbons,
      count: (smoke.count - 1) * LINES * 6,
      textures: { uParcels: this.#parcels, uDepth: depth, ...volume.textures },
      uniforms: {
        uNewest: smoke.newest,
        uCount: smoke.count,
      },
      blocks: { Frame: frame, Light: light, Volume: volume.block },
      blend: "premultiplied",
      cull: "none",
    });
  }
}

/** Bounding spheres of the smoke, one for each row of parcels. */
export function* boundingSpheres({ parcels, newest, count }: Smoke): Generator<Sphere> {
  for (let age = 0; age < count; age++) {
    const first = ((newest - age + ROWS) % ROWS) * LINES * SMOKE_FLOATS;
    const end = first + LINES * SMOKE_FLOATS;
    let [x, y, z, radius] = [0, 0, 0, 0];
    for (let at = first; at < end; at += SMOKE_FLOATS) {
      x += parcels[at]! / LINES;
      y += parcels[at + 1]! / LINES;
      z += parcels[at + 2]! / LINES;
    }
    for (let at = first; at < end; at += SMOKE_FLOATS) {
      const distance = Math.hypot(parcels[at]! - x, parcels[at + 1]! - y, parcels[at + 2]! - z);
      radius = Math.max(radius, distance + REACH * parcels[at + 4]!);
    }
    yield [x, y, z, radius];
  }
}

/** Two triangles between each parcel and the next older one on its line; the youngest first. */
function ribbonIndices(): Uint16Array {
  const indices = new Uint16Array((ROWS - 1) * LINES * 6);
  for (let n = 0; n < (ROWS - 1) * LINES; n++) {
    const young = 2 * n;
    const old = 2 * (n + LINES);
    indices.set([young, young + 1, old, old, young + 1, old + 1], n * 6);
  }
  return indices;
}
