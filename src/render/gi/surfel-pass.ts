import { mat4 } from "gl-matrix";
import radiosityFrag from "../../../shaders/gi/radiosity.frag";
import supportFrag from "../../../shaders/gi/support-radiosity.frag";
import surfelFrag from "../../../shaders/gi/surfel.frag";
import surfelOutgoingFrag from "../../../shaders/gi/surfel-outgoing.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Vec3 } from "../../world/geometry.js";
import { floats } from "../float-format.js";
import type { CaptureLight } from "../light-block.js";
import { clipFromFace, FACES } from "../shadow/cube-map.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";

/** Surfels that a light falls on, captured and lit: by a flame, or by the moon. */
export interface Surfels
  extends Pick<
    SurfelPass,
    | "normalDistance"
    | "radiosity"
    | "outgoing"
    | "support"
    | "clear"
    | "capture"
    | "renderRadiosity"
    | "renderOutgoing"
  > {
  /** The block of the light, by its name. */
  readonly light: Readonly<Record<string, UniformBlock>>;
  /** Of shaders that read the surfels. */
  readonly defines: Readonly<Record<string, number>>;
}

/** Surfels: the surfaces that the flame lights, a cube around it: `lib/surfels.glsl`. */
export class SurfelPass implements Surfels {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #size: number;
  readonly #captureProgram: Program;
  readonly #radiosityProgram: Program;
  readonly #outgoingProgram: Program;
  readonly #supportProgram: Program;
  readonly #surfels: RenderTarget;
  readonly #radiosity: RenderTarget;
  readonly #outgoing: RenderTarget;
  readonly #support: RenderTarget;
  readonly light: { readonly Light: UniformBlock };
  readonly defines = {};

  /** @param size surfels along an edge of the cube */
  constructor(gpu: Gpu, screen: VertexArray, size: number) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#size = size;
    this.#captureProgram = gpu.program("gi/surfel", cubeFaceVert, surfelFrag);
    this.#radiosityProgram = gpu.program("gi/radiosity", fullscreenVert, radiosityFrag);
    this.#outgoingProgram = gpu.program("gi/surfel-outgoing", fullscreenVert, surfelOutgoingFrag);
    this.#supportProgram = gpu.program("gi/support-radiosity", fullscreenVert, supportFrag);
    this.light = { Light: gpu.uniformBlock(this.#radiosityProgram, "Light") };
    const texel = floats(gpu, 4);
    const cube = { width: size * FACES.length, height: size, filter: "nearest" } as const;
    this.#surfels = gpu.renderTarget({
      label: "gi/surfels",
      ...cube,
      color: [texel, texel],
      depth: "buffer",
    });
    const radiosity = (label: string) =>
      gpu.renderTarget({ label, ...cube, color: ["RGBA16F"] as const });
    this.#radiosity = radiosity("gi/radiosity");
    this.#outgoing = radiosity("gi/surfel-outgoing");
    this.#support = gpu.renderTarget({
      label: "gi/support-radiosity",
      width: 1,
      height: 1,
      color: [texel],
      filter: "nearest",
    });
  }

  /** Normal, and distance from the capture origin. */
  get normalDistance(): Texture {
    return this.#colors.uSurfelNormalDistance;
  }

  /** In direct light, lm/m². */
  get radiosity(): Texture {
    return this.#radiosity.color;
  }

  /** In all light, lm/m². */
  get outgoing(): Texture {
    return this.#outgoing.color;
  }

  /** Of the surface below the flame, for `lib/support-irradiance.glsl`. */
  get support(): Texture {
    return this.#support.color;
  }

  clear(): void {
    this.#gpu.clear(this.#surfels, [0, 0, 0, 0]);
  }

  capture(casters: ShadowCasters, captureOrigin: Vec3, face: number): void {
    const size = this.#size;
    const clipFromWorld = clipFromFace(face, captureOrigin, mat4.create()) as Float32Array;
    casters.drawWithAlbedo(face, captureOrigin, {
      program: this.#captureProgram,
      target: this.#surfels,
      viewport: [face * size, 0, size, size],
      uniforms: { uClipFromWorld: clipFromWorld, uCaptureOrigin: captureOrigin },
      depth: "test-and-write",
      cull: "none",
    });
  }

  /** What the surfels, and the surface below the flame, reflect of a light. */
  renderRadiosity(light: CaptureLight): void {
    this.light.Light.update(light);
    const pass = {
      vertexArray: this.#screen,
      textures: this.#colors,
      blocks: this.light,
    };
    this.#gpu.draw({ ...pass, program: this.#radiosityProgram, target: this.#radiosity });
    this.#gpu.draw({ ...pass, program: this.#supportProgram, target: this.#support });
  }

  /** The same with indirect light, by the irradiance volume. */
  renderOutgoing(volume: Readonly<Record<string, Texture>>, block: UniformBlock): void {
    this.#gpu.draw({
      program: this.#outgoingProgram,
      target: this.#outgoing,
      vertexArray: this.#screen,
      textures: { ...this.#colors, uRadiosity: this.#radiosity.color, ...volume },
      blocks: { ...this.light, Volume: block },
    });
  }

  get #colors() {
    const [uSurfelReflectance, uSurfelNormalDistance] = this.#surfels.colors;
    if (!uSurfelReflectance || !uSurfelNormalDistance) {
      throw new Error("Surfels take two textures: reflectance, and normal with distance.");
    }
    return { uSurfelReflectance, uSurfelNormalDistance };
  }
}
