import rayAlbedoFrag from "../../../shaders/gi/ray-albedo.frag";
import rayAlbedoVert from "../../../shaders/gi/ray-albedo.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import { floats } from "../float-format.js";
import type { Mesh } from "../mesh/mesh.js";
import { PROBE_DEPTH_EDGE, type ProbeDetail, type ProbeRays } from "./probe-rays.js";

/** Bytes of a float. */
const FLOAT = 4;

/** Probes and the hits of their rays, as textures. */
export interface ProbeTextures {
  /** For shaders that include `lib/irradiance-volume.glsl`. */
  readonly volume: { readonly uProbePositions: Texture; readonly uProbeDepth: Texture };
  /** For shaders that include `lib/probe-rays.glsl`. */
  readonly rays: { readonly uRayHits: Texture; readonly uRayAlbedo: Texture };
}

/** @param surfaces of the traced model, in the order of its parts */
export function uploadProbeRays(
  gpu: Gpu,
  traced: ProbeRays,
  { probes: [columns, rows, planes], rays }: ProbeDetail,
  surfaces: readonly Mesh[],
): ProbeTextures {
  const tiles = { width: columns * planes, height: rows };
  const uProbePositions = gpu.texture({
    label: "gi/probe-positions",
    format: "RGBA32F",
    source: { ...tiles, data: traced.positions },
    filter: "nearest",
  });
  const uProbeDepth = gpu.texture({
    label: "gi/probe-depth",
    format: floats(gpu, 2),
    source: {
      width: tiles.width * PROBE_DEPTH_EDGE,
      height: tiles.height * PROBE_DEPTH_EDGE,
      data: traced.depths,
    },
  });
  const size = { width: tiles.width * rays, height: tiles.height * rays };
  const uRayHits = gpu.texture({
    label: "gi/ray-hits",
    format: "RGBA16F",
    source: { ...size, data: traced.hits },
    filter: "nearest",
  });
  return {
    volume: { uProbePositions, uProbeDepth },
    rays: { uRayHits, uRayAlbedo: renderRayAlbedo(gpu, traced, size, surfaces) },
  };
}

/** Base colours at the hits, read on the GPU: compressed images may be nowhere else. */
function renderRayAlbedo(
  gpu: Gpu,
  { hitUvs, runs }: ProbeRays,
  size: { readonly width: number; readonly height: number },
  surfaces: readonly Mesh[],
): Texture {
  const program = gpu.program("gi/ray-albedo", rayAlbedoVert, rayAlbedoFrag);
  const target = gpu.renderTarget({
    label: "gi/ray-albedo",
    ...size,
    color: ["RGBA8"],
    filter: "nearest",
  });
  const buffer = gpu.buffer("gi/hit-uvs", hitUvs);
  const vertexArray = gpu.vertexArray("gi/hit-uvs", {
    attributes: {
      0: { buffer, size: 2, stride: 4 * FLOAT },
      1: { buffer, size: 2, stride: 4 * FLOAT, offset: 2 * FLOAT },
    },
    count: hitUvs.length / 4,
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
        uNormalScale: surface.parameters[2],
      },
      textures: { uAlbedo: surface.textures.uAlbedo, uNormal: surface.textures.uNormal },
    });
  }
  for (const object of [vertexArray, buffer]) object.dispose();
  return target.color;
}
