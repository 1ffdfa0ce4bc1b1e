import type { mat4 } from "gl-matrix";
import smokeFrag from "../../../shaders/volumetric/smoke.frag";
import smokeVert from "../../../shaders/volumetric/smoke.vert";
import type { Draw, Gpu, Program, Texture, UniformBlock, VertexArray } from "../../gl/gpu.js";
import { luma } from "../../light/color.js";
import { carriedFlame, emberIntensity } from "../../light/flame-light.js";
import { WICK_END } from "../../world/air/plume.js";
import type { Flame } from "../../world/flame/flame.js";
import { rootedFlame } from "../../world/flames.js";
import { length3, type Vec3 } from "../../world/geometry.js";
import { LINES, ROWS, SMOKE_FLOATS, type Smoke } from "../../world/particles/smoke.js";
import type { World } from "../../world/world.js";
import { FlameLights, MOST_FLAMES } from "../lone-candle/flame-lights.js";
import type { Sphere } from "../screen-bounds.js";
import type { BurningWick } from "./flame-pass.js";
import { FAINT, LEAST_SINE, MOST_SECTIONS, opticalDepth, setSections } from "./smoke-sections.js";

/** Most half width of a ribbon, in standard deviations. */
const REACH = 2.4;
/** Most by which a line leaves the straight way between two rows, as a share of it. */
const BULGE = 0.25;

/** Youngest rows that follow the wick's tip, which the air knows neither between its steps nor where a wick leans. */
const LED_ROWS = 8;

/** Light of the place that smoke scatters, beside that of standing flames, and what it is drawn with. */
type SmokeDraw = Pick<Draw, "target" | "textures" | "uniforms" | "blocks">;

/** Of all candles, the carried one's first. */
type Wicks = readonly Pick<BurningWick, "nodes">[];

/** Smoke of the wicks: streaklines of droplets that scatter the light around. */
export class SmokePass {
  readonly #gpu: Gpu;
  readonly #isAlone: boolean;
  readonly #program: Program;
  readonly #flames: UniformBlock;
  readonly #lights = new FlameLights();
  readonly #parcels: Texture;
  readonly #sections: Texture;
  readonly #ends = new Float32Array(MOST_SECTIONS);
  readonly #ribbons: VertexArray;

  /** @param isAlone over a page, in place of a room */
  constructor(gpu: Gpu, isAlone: boolean) {
    this.#gpu = gpu;
    this.#isAlone = isAlone;
    this.#program = gpu.program("volumetric/smoke", smokeVert, smokeFrag, {
      defines: {
        LINES,
        ROWS,
        LED_ROWS,
        REACH,
        FAINT,
        LEAST_SINE,
        ...(isAlone ? { ALONE: 1 } : {}),
      },
    });
    this.#flames = gpu.uniformBlock(this.#program, "Flames");
    this.#parcels = gpu.texture({
      label: "smoke/parcels",
      format: "RGBA32F",
      source: { width: (LINES * SMOKE_FLOATS) / 4, height: ROWS },
      filter: "nearest",
    });
    this.#sections = gpu.texture({
      label: "smoke/sections",
      format: "R32F",
      source: { width: MOST_SECTIONS, height: 1 },
      filter: "nearest",
    });
    const indices = ribbonIndices();
    this.#ribbons = gpu.vertexArray("smoke/ribbons", {
      attributes: {},
      indices: { buffer: gpu.buffer("smoke/indices", indices, "index"), type: "uint16" },
      count: indices.length,
    });
  }

  /** @param wicks of all candles */
  render(world: World, clip: mat4, draw: SmokeDraw, wicks: Wicks): void {
    const smokes = [...visibleSmokes(world, wicks)];
    if (smokes.length === 0) return;
    const flames = [...(this.#isAlone ? [carriedFlame(world)] : []), ...world.standing];
    const burning = flames.filter(({ flame }) => flame.glow > 0).slice(0, MOST_FLAMES);
    const members = this.#lights.members(burning, clip, false, 0);
    const intensities = members["intensities[0]"];
    for (const [i, { flame }] of burning.entries()) {
      for (let at = 4 * i; at < 4 * i + 3; at++) intensities[at]! *= lightShare(flame);
    }
    this.#flames.update(members);
    const uShare = this.#isAlone ? {} : { uShare: carriedShare(world.flame) };
    for (const { smoke, moved } of smokes) {
      this.#parcels.update(smoke.parcels);
      const pieces = setSections(this.#ends, smoke);
      this.#sections.update(this.#ends);
      this.#gpu.draw({
        ...draw,
        program: this.#program,
        vertexArray: this.#ribbons,
        count: pieces * LINES * 6,
        textures: { uParcels: this.#parcels, uSections: this.#sections, ...draw.textures },
        uniforms: {
          uNewest: smoke.newest,
          uCount: smoke.count,
          uMoved: moved,
          ...uShare,
          ...draw.uniforms,
        },
        blocks: { Flames: this.#flames, ...draw.blocks },
        blend: "premultiplied",
        depth: this.#isAlone ? "test" : "none",
        cull: "none",
      });
    }
  }
}

/**
 * Share of a flame's light that reaches smoke. The light of one that is out lingers only lest it flash, and comes from the
 * wick's tip: it would be a lamp beside the smoke.
 */
const lightShare = ({ presence }: Flame) => presence * presence;

/** The same of the carried flame, whose light is at last its ember's. */
function carriedShare(flame: Flame): number {
  if (flame.glow === 0) return 1;
  return Math.max(lightShare(flame), Math.min(luma(emberIntensity(flame)) / flame.glow, 1));
}

interface VisibleSmoke {
  readonly smoke: Smoke;
  /** Way from where the youngest parcels were born to the tip of its wick, metres. */
  readonly moved: Vec3;
}

function* visibleSmokes(world: World, wicks: Wicks): Generator<VisibleSmoke> {
  for (const [index, { plume }] of [world, ...world.standing].entries()) {
    const root = rootedFlame(world, index)?.root;
    if (!root || !plume || plume.smoke.count < 2) continue;
    const [x, y, z] = plume.wayTo(root);
    const tip = wicks[index]!.nodes.at(-1)!;
    yield { smoke: plume.smoke, moved: [x + tip[0], y + tip[1] - WICK_END, z + tip[2]] };
  }
}

export function* smokeSpheres(world: World, wicks: Wicks): Generator<Iterable<Sphere>> {
  for (const smoke of visibleSmokes(world, wicks)) yield spheresOf(smoke);
}

/** One for each row of parcels that is seen, or next to one that is. */
function* spheresOf(visible: VisibleSmoke): Generator<Sphere> {
  const rows = Array.from({ length: visible.smoke.count }, (_, age) => sphereOf(visible, age));
  for (const [age, { middle, radius }] of rows.entries()) {
    const around = rows.slice(Math.max(age - 1, 0), age + 2);
    if (!around.some(({ isSeen }) => isSeen)) continue;
    const [x, y, z] = middle;
    const apart = around.map(({ middle: [a, b, c] }) => length3(a - x, b - y, c - z));
    yield [x, y, z, radius + BULGE * Math.max(...apart)];
  }
}

/** A row's parcels and the breadth of their lines, from the youngest. */
function sphereOf({ smoke: { parcels, newest }, moved }: VisibleSmoke, age: number) {
  const first = ((newest - age + ROWS) % ROWS) * LINES * SMOKE_FLOATS;
  const end = first + LINES * SMOKE_FLOATS;
  let [x, y, z, radius, isSeen] = [0, 0, 0, 0, false];
  for (let at = first; at < end; at += SMOKE_FLOATS) {
    x += parcels[at]! / LINES;
    y += parcels[at + 1]! / LINES;
    z += parcels[at + 2]! / LINES;
  }
  for (let at = first; at < end; at += SMOKE_FLOATS) {
    const distance = Math.hypot(parcels[at]! - x, parcels[at + 1]! - y, parcels[at + 2]! - z);
    const breadth = parcels[at + 4]!;
    const excess = opticalDepth(parcels, at) / FAINT;
    isSeen ||= excess > 1;
    const reach = Math.sqrt(2 * Math.log(Math.max(excess, 1)));
    radius = Math.max(radius, distance + Math.min(reach, REACH) * breadth);
  }
  const share = Math.max(0, 1 - age / LED_ROWS);
  const middle: Vec3 = [x + moved[0] * share, y + moved[1] * share, z + moved[2] * share];
  return { middle, radius, isSeen };
}

/** Two triangles for each piece of each line; the youngest first. */
function ribbonIndices(): Uint16Array {
  const pieces = (MOST_SECTIONS - 1) * LINES;
  const indices = new Uint16Array(pieces * 6);
  for (let n = 0; n < pieces; n++) {
    const corners = [0, 1, 2, 2, 1, 3].map((corner) => 4 * n + corner);
    indices.set(corners, n * 6);
  }
  return indices;
}
