import depthFrag from "../../../shaders/mesh/depth.frag";
import meshVert from "../../../shaders/mesh/mesh.vert";
import type { Box, Gpu, Program, RenderTarget, Texture, UniformBlock } from "../../gl/gpu.js";
import { frustumTest } from "../camera.js";
import type { FrameInput, Size } from "../frame-input.js";
import { visibleRuns } from "../mesh/visible-runs.js";
import { clipOfBox } from "../screen-bounds.js";
import { TILE } from "./tiles.js";

/** Edge of the blocks that it is drawn in, pixels. */
const BLOCK = 4 * TILE;

/** Depth of a frame's meshes, a block at a time: a software renderer shades what depth then hides. */
export class DepthPrepass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #frame: UniformBlock;
  #target: RenderTarget | null = null;
  /** Corners of the blocks that have been drawn, and the view that they are of. */
  readonly #drawn = new Set<string>();
  #view = "";

  /** @param block `Frame` of a program with the same vertex shader */
  constructor(gpu: Gpu, block: UniformBlock) {
    this.#gpu = gpu;
    this.#program = gpu.program("mesh/depth", meshVert, depthFrag);
    this.#frame = block;
  }

  resize(size: Size): void {
    this.#target?.dispose();
    const options = { label: "refinement/prepass", color: [], depth: "texture" } as const;
    this.#target = this.#gpu.renderTarget({ ...options, ...size });
    this.#view = "";
  }

  /** Depth of all blocks drawn for this view, that around a tile among them. */
  depthAround([x, y]: Box, frame: FrameInput): Texture {
    const target = this.#target!;
    // A hidden candle hides nothing.
    const placements = frame.instances.map(({ placement }) => placement);
    const view = JSON.stringify([[...frame.clipFromWorld], placements]);
    if (view !== this.#view) {
      this.#view = view;
      this.#drawn.clear();
      this.#gpu.clear(target, [0, 0, 0, 0]);
    }
    const corner = [Math.floor(x / BLOCK) * BLOCK, Math.floor(y / BLOCK) * BLOCK] as const;
    if (!this.#drawn.has(`${corner}`)) this.#draw(frame, target, [...corner, BLOCK, BLOCK]);
    this.#drawn.add(`${corner}`);
    return target.depth!;
  }

  #draw({ instances, clipFromWorld }: FrameInput, target: RenderTarget, scissor: Box): void {
    const isVisible = frustumTest(clipOfBox(scissor, target, clipFromWorld));
    for (const { meshes, placement } of instances) {
      for (const mesh of meshes) {
        // What lies behind holes in a mesh is visible.
        if (mesh.isCutOut) continue;
        for (const run of visibleRuns(mesh, placement, isVisible)) {
          this.#gpu.draw({
            program: this.#program,
            target,
            vertexArray: mesh.vertexArray,
            uniforms: { uPlacement: placement },
            blocks: { Frame: this.#frame },
            depth: "test-and-write",
            cull: mesh.isDoubleSided ? "none" : "back",
            scissor,
            ...run,
          });
        }
      }
    }
  }
}
