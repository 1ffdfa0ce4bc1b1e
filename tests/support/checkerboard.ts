import meshVert from "../../shaders/mesh/mesh.vert";
import { Gpu } from "../../src/gl/gpu.ts";
import type { Texture } from "../../src/gl/texture.ts";
import { clipFromWorld } from "../../src/render/camera.ts";
import {
  AT_ORIGIN,
  type FrameInput,
  type ModelInstance,
  type Placement,
} from "../../src/render/frame-input.ts";
import type { Mesh } from "../../src/render/mesh/mesh.ts";
import { Checkerboard } from "../../src/render/opaque/checkerboard.ts";
import { allFeatures } from "../../src/settings.ts";
import type { Vec3 } from "../../src/world/geometry.ts";
import placeFrag from "./place.frag";

const SIZE = { width: 128, height: 96 } as const;

/** A wall, before it a board, and one of which half is cut out, and another that is held. Runs in the browser. */
export class CheckerboardScene {
  readonly size = SIZE;
  readonly #gpu: Gpu;
  readonly #checkerboard: Checkerboard;
  readonly #program;
  readonly #frame;
  readonly #samples;
  readonly #resolved;
  readonly #wall: Mesh;
  readonly #board: Mesh;
  readonly #cutOut: Mesh;
  readonly #held: Mesh;
  readonly #isStill: boolean;

  /** @param isStill whether its light does not move */
  constructor(isStill = false) {
    this.#isStill = isStill;
    const canvas = document.createElement("canvas");
    Object.assign(canvas, SIZE);
    const gpu = new Gpu(canvas);
    this.#gpu = gpu;
    this.#program = gpu.program("place", meshVert, placeFrag);
    this.#frame = gpu.uniformBlock(this.#program, "Frame");
    this.#checkerboard = new Checkerboard(gpu, this.#frame);
    const options = { ...SIZE, color: ["RGBA16F"], depth: "texture" } as const;
    this.#samples = gpu.renderTarget({ label: "samples", ...options, samples: 4 });
    this.#resolved = gpu.renderTarget({ label: "resolved", ...options });
    this.#wall = square(gpu, [0, 0, -4], 6);
    this.#board = square(gpu, [0.2, 0, -2], 0.3);
    this.#cutOut = square(gpu, [0.9, 0, -3], 0.6, true);
    this.#held = square(gpu, [0, 0, 0], 0.1);
  }

  /**
   * Draws a frame.
   *
   * @param held place of what is held
   * @returns by pixel, rows from the bottom: the place that is seen there, metres, and a number below 0 if it was kept
   */
  draw(eye: Vec3, yaw: number, held: Vec3): Float32Array {
    const gpu = this.#gpu;
    const clip = clipFromWorld(eye, yaw, 0, SIZE.width / SIZE.height);
    this.#frame.update({
      clipFromWorld: clip,
      eyePosition: eye,
      exposure: 1,
      viewport: [SIZE.width, SIZE.height],
      projectionScale: 1,
      normalMaps: 1,
    });
    const instance = (mesh: Mesh, placement: Placement, isHeld: boolean): ModelInstance => ({
      meshes: [mesh],
      placement,
      isHeld,
    });
    const instances = [
      instance(this.#wall, AT_ORIGIN, false),
      instance(this.#board, AT_ORIGIN, false),
      instance(this.#cutOut, AT_ORIGIN, false),
      instance(this.#held, [...held, 0], true),
    ];
    const frame = { clipFromWorld: clip, instances, settings: { features: allFeatures() } };
    gpu.clear(this.#samples, [0, 0, 0, 1]);
    const drawn = this.#checkerboard.draw(
      frame as unknown as FrameInput,
      { key: "", flame: 1, moon: 1, isStill: this.#isStill },
      this.#samples,
      this.#resolved,
      () => {
        for (const { meshes, placement } of instances) {
          for (const { vertexArray, textures, isCutOut } of meshes) {
            const cutOut = { defines: { CUTOUT: 1 } };
            gpu.draw({
              program: isCutOut ? gpu.program("place", meshVert, placeFrag, cutOut) : this.#program,
              textures,
              target: this.#samples,
              vertexArray,
              uniforms: { uPlacement: placement },
              blocks: { Frame: this.#frame },
              depth: "test-and-write",
            });
          }
        }
      },
    );
    return this.#read(drawn.radiance);
  }

  #read(texture: Texture): Float32Array {
    const view = this.#gpu.textureView({ label: "read", textures: [texture], image: 0 });
    const { width, height } = SIZE;
    const texels = new Float32Array(width * height * 4);
    const gl = this.#gpu.canvas.getContext("webgl2")!;
    gl.bindFramebuffer(gl.FRAMEBUFFER, view.framebuffer);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    view.dispose();
    return texels.map((value, i) => (i % 4 < 3 ? value - 8 : value));
  }

  /** Forgets the frames before. */
  release(): void {
    this.#checkerboard.release();
  }

  dispose(): void {
    this.#gpu.dispose();
  }
}

/** A square that faces +Z; of one that is cut out the right half is missing. */
function square(gpu: Gpu, [x, y, z]: Vec3, side: number, isCutOut = false): Mesh {
  const half = side / 2;
  const corners = [
    [-half, -half],
    [half, -half],
    [half, half],
    [-half, half],
  ];
  const positions = Float32Array.from(
    corners.flatMap(([across = 0, up = 0]) => [x + across, y + up, z]),
  );
  const indices = Uint16Array.of(0, 1, 2, 0, 2, 3);
  const min = [x - half, y - half, z] as const;
  const max = [x + half, y + half, z] as const;
  const uvs = Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1);
  const source = { width: 2, height: 1, data: Uint8Array.of(0, 0, 0, 255, 0, 0, 0, 0) };
  const mesh = {
    isCutOut,
    textures: {
      uAlbedo: gpu.texture({ label: "half", format: "RGBA8", source, filter: "nearest" }),
    },
    part: { positions, indices },
    isDoubleSided: false,
    clusters: [{ min, max, first: 0, count: indices.length }],
    uniforms: { uBaseColor: [1, 1, 1, 1], uSurface: [1, 0, 1, isCutOut ? 0.5 : 0] },
    vertexArray: gpu.vertexArray("square", {
      attributes: {
        0: { buffer: gpu.buffer("positions", positions), size: 3 },
        3: { buffer: gpu.buffer("uvs", uvs), size: 2 },
      },
      indices: { buffer: gpu.buffer("indices", indices, "index"), type: "uint16" },
      count: indices.length,
    }),
  };
  return mesh as unknown as Mesh;
}
