import { mat4 } from "gl-matrix";
import gatherFrag from "../../../shaders/gi/gather-rays.frag";
import probeFrag from "../../../shaders/gi/gather-surfels.frag";
import irradianceFrag from "../../../shaders/gi/irradiance.frag";
import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import glimpseFrag from "../../../shaders/gi/ray-direct.frag";
import echoFrag from "../../../shaders/gi/ray-radiance.frag";
import belowFrag from "../../../shaders/gi/support-radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import surfelVert from "../../../shaders/gi/surfel.vert";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Model } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Vec3 } from "../../world/geometry.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import type { Surface } from "../mesh/mesh.js";
import { SCHEDULE } from "../schedule.js";
import { clipFromFace, FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import { LIT, type ProbeDetail, TILE, traceProbes } from "./probe-rays.js";
import { type ProbeTextures, uploadProbeRays } from "./probe-textures.js";

/** How finely indirect light is known. */
export interface IndirectDetail extends ProbeDetail {
  /** Patches along an edge of the cube around the flame. */
  readonly patches: number;
  /** Times that light is passed on. */
  readonly bounces: number;
  /** Whether a place is lit only by the probes in its sight; otherwise by all that are near. */
  readonly looks: boolean;
}

/** The room whose surfaces pass light on. */
export interface IndirectScene {
  readonly model: Model;
  readonly collision: CollisionMesh;
  /** Of the model, in the order of its parts. */
  readonly surfaces: readonly Surface[];
}

/** Indirect light everywhere in the room, for shaders that include `lib/irradiance-volume.glsl`. */
export interface IrradianceVolume {
  readonly block: UniformBlock;
  readonly textures: {
    readonly uIrradiance: Texture;
    readonly uProbePositions: Texture;
    readonly uProbeDepth: Texture;
  };
  /** What the patches send back, lm/m²: for `lib/distance-impostor.glsl`. */
  readonly radiosity: Texture;
  /** The surface below the flame, for `lib/support-irradiance.glsl`; null where probes look for themselves. */
  readonly below: Texture | null;
}

/**
 * Light that has bounced off the room, without any precomputation.
 *
 * The flame sees the room as a few hundred patches, and probes gather their light as far as they see them.
 * Each probe knows what its rays meet, and gathers what that throws back of the flame's light where patches
 * are too coarse, and of the probes' light, for a number of bounces. `render` starts from darkness each time,
 * so its result depends on where the flame is and on nothing drawn before; `follow` goes on from what it had.
 * Light adds up, so a flame that flickers changes only what the result is multiplied by.
 */
export class IndirectPass {
  readonly #gpu: Gpu;
  readonly #detail: IndirectDetail;
  readonly #surfelProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #probeProgram: Program;
  readonly #echoProgram: Program;
  readonly #glimpseProgram: Program;
  readonly #gatherProgram: Program;
  readonly #irradianceProgram: Program;
  readonly #screen: VertexArray;
  readonly #block: UniformBlock;
  readonly #below: { readonly program: Program; readonly target: RenderTarget } | null;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #echo: RenderTarget;
  readonly #first: RenderTarget;
  readonly #all: RenderTarget;
  readonly #irradiance: RenderTarget;
  readonly #light: UniformBlock;
  readonly #room: IndirectScene;
  #uploaded: ProbeTextures | null = null;
  /** What the volume was made from. */
  #lastLight = "";
  /** Whether nothing that was drawn before is in it. */
  #isExact = false;
  /** What is being captured, a face at a time. */
  #begun: { readonly light: CaptureLight; faces: number } | null = null;
  /** Pictures until it may follow a light again. */
  #rest = 0;

  constructor(gpu: Gpu, screen: VertexArray, room: IndirectScene, detail: IndirectDetail) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#detail = detail;
    const defines = { RAYS: detail.rays };
    this.#surfelProgram = gpu.program("gi/surfel", surfelVert, surfelFrag);
    this.#radiosityProgram = gpu.program("gi/radiosity", fullscreenVert, radiosityFrag);
    this.#probeProgram = gpu.program("gi/gather-surfels", fullscreenVert, probeFrag, { defines });
    this.#echoProgram = gpu.program("gi/ray-radiance", fullscreenVert, echoFrag, { defines });
    this.#glimpseProgram = gpu.program("gi/ray-direct", fullscreenVert, glimpseFrag, {
      defines,
    });
    this.#gatherProgram = gpu.program("gi/gather-rays", fullscreenVert, gatherFrag, { defines });
    this.#irradianceProgram = gpu.program("gi/irradiance", fullscreenVert, irradianceFrag);
    this.#light = gpu.uniformBlock(this.#radiosityProgram, "Light");
    const [columns, rows, planes] = detail.probes;
    const { min, max } = room.model.bounds;
    this.#block = gpu.uniformBlock(this.#echoProgram, "Volume");
    this.#block.update({
      corner: min,
      // A floor without walls is a room, too.
      extent: min.map((low, axis) => Math.max((max[axis] ?? low) - low, 0.01)),
      columns,
      rows,
      planes,
      looks: detail.looks ? 1 : 0,
    });
    const texel = floats(gpu, 4);
    const patches = { width: detail.patches * FACES.length, height: detail.patches };
    this.#surfels = gpu.renderTarget({
      label: "indirect/surfels",
      ...patches,
      color: [texel, texel],
      depth: "buffer",
      filter: "nearest",
    });
    const one = { width: 1, height: 1, color: [texel], filter: "nearest" } as const;
    this.#below = detail.looks
      ? null
      : {
          program: gpu.program("gi/support-radiosity", fullscreenVert, belowFrag),
          target: gpu.renderTarget({ label: "indirect/below", ...one }),
        };
    const radiance = { color: ["RGBA16F"], filter: "nearest" } as const;
    this.#radiosity = gpu.renderTarget({ label: "indirect/radiosity", ...patches, ...radiance });
    const tiles = { width: columns * planes, height: rows };
    const rays = { width: tiles.width * detail.rays, height: tiles.height * detail.rays };
    this.#echo = gpu.renderTarget({ label: "indirect/echo", ...rays, ...radiance });
    const harmonics = {
      width: tiles.width * TILE,
      height: tiles.height,
      color: [texel, texel, texel],
      filter: "nearest",
    } as const;
    this.#first = gpu.renderTarget({ label: "indirect/first bounce", ...harmonics });
    this.#all = gpu.renderTarget({ label: "indirect/all bounces", ...harmonics });
    this.#irradiance = gpu.renderTarget({
      label: "indirect/irradiance",
      width: tiles.width * LIT,
      height: tiles.height * LIT,
      color: [texel],
    });
    this.#room = room;
  }

  /** Uploaded when they are first needed: drawing their colours waits for a program. */
  get #sights(): ProbeTextures {
    if (this.#uploaded) return this.#uploaded;
    const { collision, model, surfaces } = this.#room;
    const seen = traceProbes(collision, model, this.#detail);
    this.#uploaded = this.#gpu.share(seen, () =>
      uploadProbeRays(this.#gpu, seen, this.#detail, surfaces),
    );
    return this.#uploaded;
  }

  /**
   * Light that the room throws back for each candela of the flame's.
   *
   * @param light members of the block of `lib/flame-light.glsl`, of a flame at its vantage
   */
  render(casters: ShadowCasters, light: CaptureLight): IrradianceVolume {
    this.#begun = null;
    if (!this.#isExact || JSON.stringify(light) !== this.#lastLight) {
      this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
      for (const face of FACES.keys()) this.#capture(casters, light.position, face);
      this.#bounce(light);
    }
    return this.#volume;
  }

  /** The same of a light that moved a little while ago: its cost is spread over as many pictures. */
  follow(casters: ShadowCasters, light: CaptureLight): IrradianceVolume {
    if (this.#lastLight === "") {
      this.render(casters, light);
      this.#isExact = false; // of casters that may be coarse
      return this.#volume;
    }
    if (!this.#begun) {
      if (this.#rest-- > 0 || JSON.stringify(light) === this.#lastLight) return this.#volume;
      this.#begun = { light, faces: 0 };
      this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
    }
    if (this.#begun.faces < FACES.length) {
      this.#capture(casters, this.#begun.light.position, this.#begun.faces++);
    } else {
      this.#bounceOn(this.#begun.light);
      this.#begun = null;
      this.#rest = SCHEDULE.indirect.restFrames;
    }
    return this.#volume;
  }

  get #volume(): IrradianceVolume {
    return {
      block: this.#block,
      textures: { uIrradiance: this.#irradiance.color, ...this.#sights.room },
      radiosity: this.#radiosity.color,
      below: this.#below?.target.color ?? null,
    };
  }

  #capture(casters: ShadowCasters, vantage: Vec3, face: number): void {
    const size = this.#detail.patches;
    const clipFromWorld = clipFromFace(face, vantage, mat4.create()) as Float32Array;
    casters.drawWithAlbedo(face, vantage, {
      program: this.#surfelProgram,
      target: this.#surfels,
      viewport: [face * size, 0, size, size],
      uniforms: { uClipFromWorld: clipFromWorld, uLight: vantage },
      depth: "test-and-write",
      cull: "none",
    });
  }

  #bounce(light: CaptureLight): void {
    this.#lastLight = JSON.stringify(light);
    this.#isExact = true;
    this.#light.update(light);
    this.#reflectOnce();
    this.#irradiate(this.#first);
    for (let bounce = 1; bounce < this.#detail.bounces; bounce++) this.#bounceAgain();
  }

  /** The same where the light was nearly as it is: what it threw back then stands for all later bounces. */
  #bounceOn(light: CaptureLight): void {
    this.#lastLight = JSON.stringify(light);
    this.#isExact = false;
    this.#light.update(light);
    this.#reflectOnce();
    this.#bounceAgain();
  }

  /** What the probes see of the flame's own light. */
  #reflectOnce(): void {
    const [patchColor, normalDistance] = this.#surfels.colors;
    if (!patchColor || !normalDistance) throw new Error("A patch has a colour and a place.");
    const { uProbePositions } = this.#sights.room;
    const ofPatches = {
      vertexArray: this.#screen,
      textures: { uSurfelAlbedo: patchColor, uSurfelNormalDistance: normalDistance },
      blocks: { Light: this.#light },
    };
    const radiosity = { program: this.#radiosityProgram, target: this.#radiosity };
    this.#gpu.draw({ ...ofPatches, ...radiosity });
    if (this.#below) this.#gpu.draw({ ...ofPatches, ...this.#below });
    this.#gpu.draw({
      program: this.#probeProgram,
      target: this.#all,
      vertexArray: this.#screen,
      textures: {
        uSurfelNormalDistance: normalDistance,
        uRadiosity: this.#radiosity.color,
        uRayHits: this.#sights.rays.uRayHits,
        uProbePositions,
      },
      blocks: { Light: this.#light },
    });
    this.#gpu.draw({
      program: this.#glimpseProgram,
      target: this.#echo,
      vertexArray: this.#screen,
      textures: { uSurfelNormalDistance: normalDistance, uProbePositions, ...this.#sights.rays },
      blocks: { Light: this.#light },
    });
    this.#gather(this.#all, this.#first);
  }

  #bounceAgain(): void {
    this.#gpu.draw({
      program: this.#echoProgram,
      target: this.#echo,
      vertexArray: this.#screen,
      textures: {
        uIrradiance: this.#irradiance.color,
        ...this.#sights.room,
        ...this.#sights.rays,
      },
      blocks: { Volume: this.#block },
    });
    this.#gather(this.#first, this.#all);
    this.#irradiate(this.#all);
  }

  /** Adds what the probes' rays see. */
  #gather(radiance: RenderTarget, target: RenderTarget): void {
    this.#gpu.draw({
      program: this.#gatherProgram,
      target,
      vertexArray: this.#screen,
      textures: { ...harmonicsOf(radiance), uRayRadiance: this.#echo.color },
    });
  }

  /** @param radiance its harmonics at each probe */
  #irradiate(radiance: RenderTarget): void {
    this.#gpu.draw({
      program: this.#irradianceProgram,
      target: this.#irradiance,
      vertexArray: this.#screen,
      textures: harmonicsOf(radiance),
      blocks: { Volume: this.#block },
    });
  }
}

function harmonicsOf({ colors }: RenderTarget) {
  const [uSh0, uSh1, uSh2] = colors;
  if (!uSh0 || !uSh1 || !uSh2) throw new Error("Harmonics take three textures.");
  return { uSh0, uSh1, uSh2 };
}
