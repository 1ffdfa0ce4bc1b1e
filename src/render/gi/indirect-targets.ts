import type { Gpu, RenderTarget } from "../../gl/gpu.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import { FACES } from "../shadow/cube-map.js";
import { type IndirectDetail, IRRADIANCE_TEXELS } from "./probe-rays.js";

/** What the bounces are computed in. Lights can share it. */
export interface IndirectTargets {
  readonly rayRadiance: RenderTarget;
  readonly surfelRadiance: RenderTarget;
  readonly firstBounce: RenderTarget;
  /** The light whose bounces were last begun. */
  usedFor: CaptureLight | null;
  /** Sums after each further bounce, used in turn. */
  readonly bounces: readonly RenderTarget[];
}

/** Surfels lie in the tiles of the probes in rows as long as those of the rays. */
export function surfelRowsOf({ surfels, surfelGroup, rays }: IndirectDetail): number {
  return Math.ceil((FACES.length * (surfels / surfelGroup) ** 2) / rays);
}

/** Octahedral maps of the irradiance at all probes, lx for a flame of 1 cd: `lib/irradiance-volume.glsl`. */
export function irradianceMaps(
  gpu: Gpu,
  { probes: [columns, rows, planes] }: IndirectDetail,
  label: string,
): RenderTarget {
  return gpu.renderTarget({
    label,
    width: columns * IRRADIANCE_TEXELS,
    height: rows * planes * IRRADIANCE_TEXELS,
    color: [floats(gpu, 4)],
  });
}

/** What all probes receive along their rays, in groups of four. */
export function rayRadianceTarget(
  gpu: Gpu,
  { probes: [columns, rows, planes], rays }: IndirectDetail,
): RenderTarget {
  return gpu.renderTarget({
    label: "gi/ray-radiance",
    width: (columns * rays) / 2,
    height: (rows * planes * rays) / 2,
    color: ["RGBA16F"],
    filter: "nearest",
  });
}

export function indirectTargets(gpu: Gpu, detail: IndirectDetail): IndirectTargets {
  const [width, rows, planes] = detail.probes;
  const height = rows * planes;
  return {
    rayRadiance: rayRadianceTarget(gpu, detail),
    surfelRadiance: gpu.renderTarget({
      label: "gi/surfel-radiance",
      width: width * detail.rays,
      height: height * surfelRowsOf(detail),
      color: ["RGBA16F", "RGBA16F"],
      filter: "nearest",
    }),
    firstBounce: irradianceMaps(gpu, detail, "gi/first-bounce"),
    usedFor: null,
    bounces: ["a", "b", "c", "d"].map((label) =>
      irradianceMaps(gpu, detail, `gi/bounces/${label}`),
    ),
  };
}
