import type { Box, ProgramOptions, Texture, TextureFormat, UniformBlock } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import type { FrameInput, Size } from "../frame-input.js";
import type { GBuffer, GBufferKind } from "../gbuffer/gbuffer.js";
import type { Captures } from "../gi/light-captures.js";
import type { CompositedFrame } from "../volumetric/volumetric-target.js";

export interface FrameBlocks {
  /** Camera and exposure. */
  readonly Frame: UniformBlock;
  /** The flame as it is in this frame. */
  readonly Light: UniformBlock;
}

/** The lit surfaces of a frame, for each candela of the flame, or of the light that represents all. */
export interface OpaqueLayer {
  readonly kind: GBufferKind;
  /** What the stage's shaders composite: radiance per candela, or its factors. */
  readonly textures: Readonly<Record<string, Texture>>;
  readonly uniforms: Readonly<Record<string, readonly number[] | Float32Array>>;
  readonly blocks: FrameBlocks;
  /** Depth at the canvas's size; of kinds other than `full` it is written by `composite`. */
  readonly depth: Texture;
  /** Motion in the image since the G-buffer was filled, as a share of its size. */
  readonly motion: number;
  /** Of the deferred stage. */
  readonly gbuffer?: GBuffer;
}

/**
 * The opaque stage: room and candle, shaded forward or deferred.
 *
 * Light is linear in the flame's intensity, and changes slowly apart from it. So the stage returns radiance per
 * candela, which is kept until camera, models or light have moved.
 */
export interface OpaqueStage {
  /** Of radiance, in all stages. */
  readonly format: TextureFormat;
  readonly blocks: FrameBlocks;
  /** Of the metering pass: it reads the textures and blocks of a layer. Default: radiance. */
  readonly meterDefines?: NonNullable<ProgramOptions["defines"]>;
  /** How many images it has begun, each of another moment. */
  readonly images?: number;
  resize(size: Size): void;
  /** Forward shading has no G-buffer, and is always `full`. */
  fillGBuffer?(frame: FrameInput): Steps<GBufferKind>;
  shade(frame: FrameInput, captures: Captures): Steps<OpaqueLayer>;
  /** Radiance in cd/m² within a region. */
  composite(frame: FrameInput, layer: OpaqueLayer, target: CompositedFrame, region: Box): void;
}
