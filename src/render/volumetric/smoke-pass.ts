import type { mat4 } from "gl-matrix";
import smokeFrag from "../../../shaders/volumetric/smoke.frag";
import smokeVert from "../../../shaders/volumetric/smoke.vert";
import type { Draw, Gpu, Program, Texture, UniformBlock, VertexArray } from "../../gl/gpu.js";
import { carriedFlame } from "../../light/flame-light.js";
import { rootedFlame } from "../../world/flames.js";
import type { Vec3 } from "../../world/geometry.js";
import { LINES, ROWS, SMOKE_FLOATS, type Smoke } from "../../world/particles/smoke.js";
import type { World } from "../../world/world.js";
import { FlameLights, MOST_FLAMES } from "../lone-candle/flame-lights.js";
import type { Sphere } from "../screen-bounds.js";

/** Half width of a ribbon, in standard deviations: `REACH` of the shader. */
const REACH = 2.4;

/** Youngest rows that follow the wick between steps of the air. */
const LED_ROWS = 8;

/** Light of the place that smoke scatters, beside that of standing flames, and what it is drawn with. */
type SmokeDraw = Pick<Draw, "target" | "textures" | "uniforms" | "blocks">;

/** Smoke of the wicks: streaklines of droplets that scatter the light around. */
export class SmokePass {
  readonly #gpu: Gpu;
  readonly #isAlone: boolean;
  readonly #program: Program;
  readonly #flames: UniformBlock;
  readonly #lights = new FlameLights();
  readonly #parcels: Texture;
  readonly #ribbons: VertexArray;

  /** @param isAlone over a page, in place of a room */
  constructor(gpu: Gpu, isAlone: boolean) {
    this.#gpu = gpu;
    this.#isAlone = isAlone;
    this.#program = gpu.program("volumetric/smoke", smokeVert, smokeFrag, {
      defines: { LINES, ROWS, LED_ROWS, ...(isAlone ? { ALONE: 1 } : {}) },
    });
    this.#flames = gpu.uniformBlock(this.#program, "Flames");
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

  render(world: World, clip: mat4, draw: SmokeDraw): void {
    const smokes = [...visibleSmokes(world)];
    if (smokes.length === 0) return;
    const flames = [...(this.#isAlone ? [carriedFlame(world)] : []), ...world.standing];
    const burning = flames.filter(({ flame }) => flame.glow > 0).slice(0, MOST_FLAMES);
    this.#flames.update(this.#lights.members(burning, clip, false, 0));
    for (const { smoke, moved } of smokes) {
      this.#parcels.update(smoke.parcels);
      this.#gpu.draw({
        ...draw,
        program: this.#program,
        vertexArray: this.#ribbons,
        count: (smoke.count - 1) * LINES * 6,
        textures: { uParcels: this.#parcels, ...draw.textures },
        uniforms: { uNewest: smoke.newest, uCount: smoke.count, uMoved: moved, ...draw.uniforms },
        blocks: { Flames: this.#flames, ...draw.blocks },
        blend: "premultiplied",
        depth: this.#isAlone ? "test" : "none",
        cull: "none",
      });
    }
  }
}

interface VisibleSmoke {
  readonly smoke: Smoke;
  /** Way of its wick since the youngest parcels were born, metres. */
  readonly moved: Vec3;
}

function* visibleSmokes(world: World): Generator<VisibleSmoke> {
  for (const [index, { plume }] of [world, ...world.standing].entries()) {
    const root = rootedFlame(world, index)?.root;
    if (!root || !plume || plume.smoke.count < 2) continue;
    yield { smoke: plume.smoke, moved: plume.wayTo(root) };
  }
}

export function* smokeSpheres(world: World): Generator<Iterable<Sphere>> {
  for (const smoke of visibleSmokes(world)) yield spheresOf(smoke);
}

/** One for each row of parcels. */
function* spheresOf({ smoke: { parcels, newest, count }, moved }: VisibleSmoke): Generator<Sphere> {
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
    const share = Math.max(0, 1 - age / LED_ROWS);
    yield [x + moved[0] * share, y + moved[1] * share, z + moved[2] * share, radius];
  }
}

/** Two triangles for each piece, between a parcel and the next older one on its line; the youngest first. */
function ribbonIndices(): Uint16Array {
  const indices = new Uint16Array((ROWS - 1) * LINES * 6);
  for (let n = 0; n < (ROWS - 1) * LINES; n++) {
    const corners = [0, 1, 2, 2, 1, 3].map((corner) => 4 * n + corner);
    indices.set(corners, n * 6);
  }
  return indices;
}
