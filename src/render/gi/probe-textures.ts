import rayProbesFrag from "../../../shaders/gi/ray-probes.frag";
import rayReflectanceFrag from "../../../shaders/gi/ray-reflectance.frag";
import rayReflectanceVert from "../../../shaders/gi/ray-reflectance.vert";
import roomReflectanceFrag from "../../../shaders/gi/room-reflectance.frag";
import type { Gpu, Program, RenderTarget, UniformBlock, VertexArray } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { drawInBands } from "../draw-in-bands.js";
import { floats } from "../float-format.js";
import type { Mesh } from "../mesh/mesh.js";
import { PROBE_DEPTH_EDGE, type ProbeDetail, type ProbeRays } from "./probe-rays.js";

const FLOAT = 4;
/** Bands of the pass over all rays. */
const BANDS = 12;
/** Hits in a step: a CPU draws a few hundred points in a millisecond. */
const HITS = 4_000;

export type ProbeTextures = Readonly<ReturnType<typeof uploadProbeRays>>;

/**
 * Probes and the hits of their rays, as textures.
 *
 * @param block of `lib/irradiance-volume.glsl`
 * @param surfaces of the traced model, in the order of its parts
 */
export function uploadProbeRays(
  gpu: Gpu,
  block: UniformBlock,
  traced: ProbeRays,
  { probes: [columns, rows, planes], rays }: ProbeDetail,
  surfaces: readonly Mesh[],
) {
  const tiles = { width: columns, height: rows * planes };
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
  const volume = { uProbePositions, uProbeDepth };
  const ofRays = { ...size, color: ["RGBA8"], filter: "nearest" } as const;
  const rayProbes = gpu.renderTarget({ label: "gi/ray-probes", ...ofRays });
  const rayReflectance = gpu.renderTarget({ label: "gi/ray-reflectance", ...ofRays });
  const roomReflectance = gpu.renderTarget({
    label: "gi/room-reflectance",
    width: 1,
    height: 1,
    color: ["RGBA16F"],
    filter: "nearest",
  });
  // Made with the textures, so that they are shared, too.
  const buffer = gpu.buffer("gi/hit-uvs", traced.hitUvs);
  const points = gpu.vertexArray("gi/hit-uvs", {
    attributes: {
      0: { buffer, size: 2, stride: 4 * FLOAT },
      1: { buffer, size: 2, stride: 4 * FLOAT, offset: 2 * FLOAT },
    },
    count: traced.hitUvs.length / 4,
  });
  const hits = { uRayHits, uRayReflectance: rayReflectance.color };
  const uniforms = { uRays: rays, uProbeRows: rows };
  function* draw(): Steps {
    const ofProbes = gpu.pass("gi/ray-probes", rayProbesFrag);
    const ofRoom = gpu.pass("gi/room-reflectance", roomReflectanceFrag);
    const reflect = gpu.program("gi/ray-reflectance", rayReflectanceVert, rayReflectanceFrag);
    yield;
    yield* drawInBands(gpu, BANDS, {
      program: ofProbes,
      target: rayProbes,
      uniforms,
      textures: { uRayHits, ...volume },
      blocks: { Volume: block },
    });
    yield* drawRayReflectance(gpu, reflect, traced, points, rayReflectance, surfaces);
    for (const object of [points, buffer]) object.dispose();
    gpu.draw({
      program: ofRoom,
      target: roomReflectance,
      uniforms,
      textures: { ...hits, uProbePositions },
    });
    yield;
  }
  return {
    /** For shaders that include `lib/irradiance-volume.glsl`. */
    volume,
    /** For shaders that include `lib/probe-rays.glsl`. */
    rays: hits,
    /** Mean reflectance at the hits, one texel. */
    roomReflectance: roomReflectance.color,
    /** Two of the probes around each hit. */
    uRayProbes: rayProbes.color,
    /** Draws what depends on the hits. To be finished before use. */
    drawing: draw(),
  };
}

/** Reflectance at the hits, some of a part's in each step; sampled on the GPU, since decoded images may exist only there. */
function* drawRayReflectance(
  gpu: Gpu,
  program: Program,
  { runs }: ProbeRays,
  vertexArray: VertexArray,
  target: RenderTarget,
  surfaces: readonly Mesh[],
): Steps {
  gpu.clear(target, [0, 0, 0, 0]);
  for (const { part, first, count } of runs) {
    const surface = surfaces[part];
    if (!surface) continue;
    for (let drawn = 0; drawn < count; drawn += HITS) {
      gpu.draw({
        program,
        target,
        vertexArray,
        primitive: "points",
        first: first + drawn,
        count: Math.min(HITS, count - drawn),
        uniforms: { uSize: [target.width, target.height], ...surface.uniforms },
        textures: surface.textures,
      });
      yield;
    }
  }
}
