import { mat4 } from "gl-matrix";
import shadowFrag from "../../../shaders/physical/shadow.frag";
import shadowVert from "../../../shaders/physical/shadow.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { Vec3 } from "../../world/bounds.js";
import type { Surface } from "../surface.js";
import { clipFromFace, FACES } from "./cube.js";

/** The flame moves by less than this without anyone seeing it in the shadows, metres. */
const STILL = 0.0005;
/** Farther than anything. */
const NOTHING = [1e4, 0, 0, 1] as const;

/** What the flame sees of the room: the distance of the nearest thing in every direction. */
export class ShadowPass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #distances: Texture;
  readonly #faces: readonly TextureView[];
  #lastLight: Vec3 = [Number.NaN, 0, 0];

  /** @param size texels along an edge of the cube */
  constructor(gpu: Gpu, size: number) {
    this.#gpu = gpu;
    this.#program = gpu.program("physical/shadow", shadowVert, shadowFrag);
    const source = { width: size, height: size };
    this.#distances = gpu.texture({
      label: "shadow/distances",
      format: "R16F",
      source,
      shape: "cube",
      // A mean of what casts a shadow and what lies behind it is the distance of nothing.
      filter: "nearest",
    });
    const depth = gpu.texture({
      label: "shadow/depth",
      format: "DEPTH_COMPONENT24",
      source,
      filter: "nearest",
    });
    this.#faces = FACES.map((_, image) =>
      gpu.textureView({ label: `shadow/${image}`, textures: [this.#distances], image, depth }),
    );
  }

  /** Distances from the light, metres, in a cube. */
  render(surfaces: readonly Surface[], light: Vec3): Texture {
    const [x, y, z] = this.#lastLight;
    if (Math.hypot(light[0] - x, light[1] - y, light[2] - z) < STILL) return this.#distances;
    this.#lastLight = [...light];
    for (const [face, target] of this.#faces.entries()) {
      const clipFromWorld = clipFromFace(face, light, mat4.create());
      this.#gpu.clear(target, NOTHING);
      for (const { vertexArray } of surfaces) {
        this.#gpu.draw({
          program: this.#program,
          target,
          vertexArray,
          uniforms: { uClipFromWorld: clipFromWorld as Float32Array, uLight: light },
          depth: "test-and-write",
          cull: "none",
        });
      }
    }
    return this.#distances;
  }
}
