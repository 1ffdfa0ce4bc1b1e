import rayVirtualFrag from "../../../shaders/gi/ray-virtual.frag";
import fluxFrag from "../../../shaders/gi/virtual-flux.frag";
import type { Gpu, RenderTarget, Texture } from "../../gl/gpu.js";
import type { Vec3 } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import { floats } from "../float-format.js";
import type { IndirectPass } from "../gi/indirect-pass.js";
import { irradianceMaps } from "../gi/indirect-targets.js";
import type { IndirectDetail } from "../gi/probe-rays.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import { type ShadowAtlas, ShadowPass, shadowAtlas } from "../shadow/shadow-pass.js";
import type { MoonSurfels } from "./moon-surfels.js";

/** Of shaders that include `lib/virtual-lights.glsl`. The last are on the panes, where the sky's light comes from. */
export const VIRTUAL_LIGHTS = { VIRTUAL_LIGHTS: 32, PANE_LIGHTS: 8 } as const;
const COUNT = VIRTUAL_LIGHTS.VIRTUAL_LIGHTS;
const OF_PANES = VIRTUAL_LIGHTS.PANE_LIGHTS;

/** Texels along an edge of a shadow cube. */
const CUBE = 64;
/** What is nearer to a light casts no shadow, metres: as in shaders/lib/virtual-lights.glsl. */
const NEAR = 0.008;
/** Metres of which a turn of the normal by a radian is as far apart. */
const TURN = 0.3;
/** Of a light above what it stands for, metres. */
const HEIGHT = 0.015;
/** What surfels without a light have for its number. */
const NONE = 255;

/** A surface that the moon lights, or a pane before the sky: a position, metres, and a normal. */
interface Place {
  readonly position: Vec3;
  readonly normal: Vec3;
}

export interface LitPoint extends Place {
  readonly isPane: boolean;
}

/** A group of lit points: its mean normal, and the member nearest to its means. A mean place may be within a fold. */
export interface LitGroup extends Place {
  /** Root of the mean squared distance from the middle, metres. */
  readonly extent: number;
  readonly members: readonly number[];
}

const coordinates = ({ position, normal }: Place): number[] => [
  ...position,
  ...normal.map((share) => share * TURN),
];

function meanOf(points: readonly (readonly number[])[]): number[] {
  const sum = new Array<number>(6).fill(0);
  for (const point of points) for (let k = 0; k < 6; k++) sum[k]! += point[k]!;
  return sum.map((x) => x / points.length);
}

/**
 * Groups points by place and normal: the group that is spread widest is split in two, again and again.
 *
 * @param points null where light meets nothing
 */
export function groupLitPoints(points: readonly (LitPoint | null)[], count: number): LitGroup[] {
  const all = points.flatMap((point, i) => (point ? [i] : []));
  const at = points.map((point) => point && coordinates(point));
  const describe = (members: readonly number[]) => {
    const points = members.map((i) => at[i]!);
    const mean = meanOf(points);
    // Sums of the squared deviations along each coordinate.
    const spread = mean.map((m, k) => points.reduce((sum, point) => sum + (point[k]! - m) ** 2, 0));
    return { members, mean, spread, total: spread.reduce((sum, one) => sum + one, 0) };
  };
  const groups = all.length > 0 ? [describe(all)] : [];
  while (groups.length > 0 && groups.length < count) {
    groups.sort((a, b) => b.total - a.total);
    const { members, mean, spread, total } = groups[0]!;
    if (total < 1e-9) break;
    const axis = spread.indexOf(Math.max(...spread));
    const isLow = (i: number) => at[i]![axis]! < mean[axis]!;
    const [low, high] = [members.filter(isLow), members.filter((i) => !isLow(i))];
    groups.splice(0, 1, describe(low), describe(high));
  }
  return groups.map(({ members, mean, spread }) => {
    const turned = mean.slice(3) as Vec3;
    const length = Math.hypot(...turned) || 1;
    const off = (i: number) => at[i]!.reduce((sum, x, k) => sum + (x - mean[k]!) ** 2, 0);
    const nearest = members.reduce((best, i) => (off(i) < off(best) ? i : best));
    return {
      position: points[nearest]!.position,
      normal: turned.map((x) => x / length) as Vec3,
      extent: Math.sqrt((spread[0]! + spread[1]! + spread[2]!) / members.length),
      members,
    };
  });
}

/** For shaders that include `lib/virtual-lights.glsl`; the irradiance volume is that of all bounces but the first. */
export type VirtualLightTextures = Readonly<
  Record<"uVirtualLights" | "uVirtualFlux" | "uVirtualShadow" | "uIrradiance", Texture>
>;

/**
 * The first bounce of the moon's light and the sky's, from a few points of what they come from, each with a shadow cube.
 * Keller 1997, "Instant Radiosity".
 */
export class VirtualLights {
  readonly #gpu: Gpu;
  readonly #surfels: MoonSurfels;
  readonly #atlas: ShadowAtlas;
  readonly #flux: RenderTarget;
  readonly #indirect: IndirectPass;
  readonly #irradiance: RenderTarget;
  #places: Texture | null = null;

  constructor(gpu: Gpu, surfels: MoonSurfels, indirect: IndirectPass, detail: IndirectDetail) {
    this.#gpu = gpu;
    this.#surfels = surfels;
    this.#indirect = indirect;
    this.#irradiance = irradianceMaps(gpu, detail, "moon/later-bounces");
    this.#atlas = shadowAtlas(gpu, CUBE, COUNT, NEAR);
    this.#flux = gpu.renderTarget({
      label: "moon/virtual-flux",
      width: COUNT,
      height: 2,
      color: [floats(gpu, 4)],
      filter: "nearest",
    });
  }

  /**
   * A face of a cube in each step, or a band of the next bounce.
   *
   * @param points of the surfels, row by row
   */
  *capture(
    casters: ShadowCasters,
    points: readonly (LitPoint | null)[],
  ): Steps<VirtualLightTextures> {
    const groupsOf = (isPane: boolean, count: number) =>
      groupLitPoints(
        points.map((point) => (point?.isPane === isPane ? point : null)),
        count,
      );
    const surfaces = groupsOf(false, COUNT - OF_PANES);
    const panes = groupsOf(true, OF_PANES);
    yield;
    const numbers = new Uint8Array(points.length).fill(NONE);
    const places = new Float32Array(COUNT * 8);
    for (const [i, { position, normal, extent, members }] of [...surfaces, ...panes].entries()) {
      const slot = i < surfaces.length ? i : COUNT - OF_PANES + i - surfaces.length;
      for (const member of members) numbers[member] = slot;
      const origin = position.map((x, axis) => x + HEIGHT * normal[axis]!) as Vec3;
      places.set([...origin, extent], slot * 4);
      places.set([...normal, 0], (COUNT + slot) * 4);
      yield* new ShadowPass(this.#gpu, this.#atlas, slot).steps(casters, origin);
    }
    this.#places?.dispose();
    this.#places = this.#gpu.texture({
      label: "moon/virtual-lights",
      format: "RGBA32F",
      source: { width: COUNT, height: 2, data: places },
      filter: "nearest",
    });
    this.#renderFlux(numbers);
    const lights = {
      uVirtualLights: this.#places,
      uVirtualFlux: this.#flux.color,
      uVirtualShadow: this.#atlas.depth,
    };
    const nextBounce = {
      program: this.#gpu.pass("gi/ray-virtual", rayVirtualFrag, {
        defines: VIRTUAL_LIGHTS,
      }),
      textures: lights,
      blocks: this.#surfels.blocks,
    };
    yield* this.#indirect.bouncesAfter(nextBounce, this.#irradiance);
    return { ...lights, uIrradiance: this.#irradiance.color };
  }

  /** @param numbers of each surfel's light */
  #renderFlux(numbers: Uint8Array): void {
    const { radiosity, normalDistance, blocks, defines } = this.#surfels;
    const { width, height } = radiosity;
    const uGroups = this.#gpu.texture({
      label: "moon/groups",
      format: "R8",
      source: { width, height, data: numbers },
      filter: "nearest",
    });
    this.#gpu.draw({
      program: this.#gpu.pass("gi/virtual-flux", fluxFrag, { defines }),
      target: this.#flux,
      textures: { uGroups, uRadiosity: radiosity, uSurfelNormalDistance: normalDistance },
      blocks,
    });
    uGroups.dispose();
  }
}
