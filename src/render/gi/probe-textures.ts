import hueFrag from "../../../shaders/gi/ray-albedo.frag";
import hueVert from "../../../shaders/gi/ray-albedo.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import { floats } from "../float-format.js";
import type { Surface } from "../mesh/mesh.js";
import { type ProbeDetail, type ProbeRays, SIGHT } from "./probe-rays.js";

/** Bytes of a float. */
const FLOAT = 4;

/** What probes see, on the GPU. */
export interface ProbeTextures {
  /** For shaders that include `lib/irradiance-volume.glsl`. */
  readonly room: { readonly uProbePositions: Texture; readonly uProbeDepth: Texture };
  /** What each ray meets: its normal and distance, its base colour. */
  readonly rays: { readonly uRayHits: Texture; readonly uRayAlbedo: Texture };
}

/** @param surfaces of the model that was looked at, in the order of its parts */
export function uploadProbeRays(
  gpu: Gpu,
  sights: ProbeRays,
  { probes: [columns, rows, planes], rays }: ProbeDetail,
  surfaces: readonly Surface[],
): ProbeTextures {
  const tiles = { width: columns * planes, height: rows };
  const uProbePositions = gpu.texture({
    label: "indirect/probes",
    format: "RGBA32F",
    source: { ...tiles, data: sights.places },
    filter: "nearest",
  });
  const uProbeDepth = gpu.texture({
    label: "indirect/sights",
    format: floats(gpu, 2),
    source: { width: tiles.width * SIGHT, height: tiles.height * SIGHT, data: sights.distances },
  });
  const size = { width: tiles.width * rays, height: tiles.height * rays };
  const uRayHits = gpu.texture({
    label: "indirect/hits",
    format: "RGBA16F",
    source: { ...size, data: sights.hits },
    filter: "nearest",
  });
  return {
    room: { uProbePositions, uProbeDepth },
    rays: { uRayHits, uRayAlbedo: colored(gpu, sights, size, surfaces) },
  };
}

/** Base colours of what the rays met, read on the GPU: pictures may be nowhere else. */
function colored(
  gpu: Gpu,
  { hues, runs }: ProbeRays,
  size: { readonly width: number; readonly height: number },
  surfaces: readonly Surface[],
): Texture {
  const program = gpu.program("gi/ray-albedo", hueVert, hueFrag);
  const target = gpu.renderTarget({
    label: "indirect/hues",
    ...size,
    color: ["RGBA8"],
    filter: "nearest",
  });
  const buffer = gpu.buffer("indirect/hues", hues);
  const vertexArray = gpu.vertexArray("indirect/hues", {
    attributes: {
      0: { buffer, size: 2, stride: 4 * FLOAT },
      1: { buffer, size: 2, stride: 4 * FLOAT, offset: 2 * FLOAT },
    },
    count: hues.length / 4,
  });
  gpu.clear(target, [0, 0, 0, 0]);
  for (const { part, first, count } of runs) {
    const surface = surfaces[part];
    if (!surface) continue;
    gpu.draw({
      program,
      target,
      vertexArray,
      primitive: "points",
      first,
      count,
      uniforms: {
        uSize: [size.width, size.height],
        uBaseColor: surface.baseColor,
        uRelief: surface.parameters[2],
      },
      textures: { uAlbedo: surface.textures.uAlbedo, uNormal: surface.textures.uNormal },
    });
  }
  for (const object of [vertexArray, buffer]) object.dispose();
  return target.color;
}
