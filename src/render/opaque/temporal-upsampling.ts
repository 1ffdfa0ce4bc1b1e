import { mat4 } from "gl-matrix";
import vectorsFrag from "../../../shaders/opaque/motion-vectors.frag";
import reprojectFrag from "../../../shaders/opaque/reproject-color.frag";
import upsampleFrag from "../../../shaders/opaque/temporal-upsample.frag";
import upscaleFrag from "../../../shaders/post/upscale.frag";
import type { Box, Gpu, Program, RenderTarget, Surface, TextureFormat } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { floats } from "../float-format.js";
import type { Size } from "../frame-input.js";
import { scaleBox } from "../screen-bounds.js";
import type { OpaqueLayer } from "./opaque-stage.js";

/**
 * Share of the current frame in a pixel: of one with a new G-buffer, with the same again, and of a reprojected one. Were
 * it larger at a frame's samples, edges would be dotted; the same samples again and again would replace all others.
 */
const SHARE = { new: 0.3, same: 0.02, reprojected: 0.1 } as const;

const STILL = mat4.create() as Float32Array;
const NO_MOTION = { room: STILL, held: STILL };

interface Targets {
  readonly size: Size;
  /** Display colours of a frame, at the reduced resolution. */
  readonly color: RenderTarget;
  readonly motion: RenderTarget;
  readonly history: readonly [latest: RenderTarget, next: RenderTarget];
  /** Of the G-buffer that was accumulated last; null while there is none. */
  readonly key: string | null;
}

/**
 * Temporal upsampling: reduced frames, each of other samples, are accumulated in a history buffer of the canvas's size.
 *
 * Source: Karis 2014, "High Quality Temporal Supersampling".
 */
export class TemporalUpsampling {
  readonly #gpu: Gpu;
  readonly #vectors: Readonly<Record<"reduced" | "reprojected", Program>>;
  readonly #upsample: Program;
  readonly #reproject: Program;
  readonly #present: Program;
  #targets: Targets | null = null;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    const vectors = (REPROJECTED: 0 | 1) =>
      gpu.pass("opaque/motion-vectors", vectorsFrag, { defines: { REPROJECTED } });
    this.#vectors = { reduced: vectors(0), reprojected: vectors(1) };
    this.#upsample = gpu.pass("opaque/temporal-upsample", upsampleFrag);
    this.#reproject = gpu.pass("opaque/reproject-color", reprojectFrag);
    this.#present = gpu.pass("post/upscale", upscaleFrag);
  }

  /**
   * Shows a frame. A reprojected one reprojects the history, and only a part is composited anew.
   *
   * @param composite draws display colours at the reduced resolution, and returns the part of a reprojected frame
   * @param size of the canvas
   */
  *show(
    layer: OpaqueLayer,
    composite: (target: RenderTarget) => readonly Box[],
    screen: Surface,
    size: Size,
  ): Steps {
    const gbuffer = layer.gbuffer!;
    const isReprojected = layer.kind === "reprojected";
    this.#targets = this.#targetsFor(gbuffer.albedo, size);
    const { color, motion, history, key } = this.#targets;
    const { canvas } = this.#gpu; // it may still be of another size
    const [latest, next] = history;
    const { room, held } = gbuffer.history ?? NO_MOTION;
    this.#gpu.draw({
      program: this.#vectors[isReprojected ? "reprojected" : "reduced"],
      target: motion,
      textures: { uDepth: gbuffer.depth, uGBufferAlbedo: gbuffer.albedo },
      sampling: { uDepth: "nearest", ...(!isReprojected && { uGBufferAlbedo: "nearest" }) },
      uniforms: { uPreviousFromCurrentRoom: room, uPreviousFromCurrentHeld: held },
    });
    yield;
    const upsample = (target: Surface, uShare: number, scissor?: Box) =>
      this.#gpu.draw({
        program: this.#upsample,
        target,
        textures: {
          uSource: color.color,
          uSmooth: color.color,
          uMotion: motion.color,
          uHistory: latest.color,
        },
        sampling: { uSource: "nearest", uMotion: "nearest" },
        uniforms: { uSampleOffset: gbuffer.sampleOffset, uShare },
        scissor,
      });
    if (isReprojected) {
      this.#gpu.draw({
        program: this.#reproject,
        target: screen,
        textures: { uHistory: latest.color, uMotion: motion.color },
        sampling: { uMotion: "nearest" },
      });
      yield;
      const boxes = composite(color);
      yield;
      for (const box of boxes) upsample(screen, SHARE.reprojected, scaleBox(box, color, canvas));
      return;
    }
    composite(color);
    yield;
    const isFirst = !gbuffer.history || key === null;
    upsample(next, isFirst ? 1 : key === gbuffer.key ? SHARE.same : SHARE.new);
    this.#targets = { ...this.#targets, history: [next, latest], key: gbuffer.key };
    yield;
    this.#gpu.draw({
      program: this.#present,
      target: screen,
      textures: { uSource: next.color },
      ...(isOfSize(canvas, size) && { sampling: { uSource: "nearest" } }),
    });
  }

  #targetsFor(reduced: Size, size: Size): Targets {
    const old = this.#targets;
    const { width, height } = size;
    if (old && isOfSize(old.size, size)) return old;
    for (const target of old ? [old.color, old.motion, ...old.history] : []) target.dispose();
    const target = (name: string, { width, height }: Size, format: TextureFormat = "RGBA8") =>
      this.#gpu.renderTarget({ label: `temporal/${name}`, width, height, color: [format] });
    const latest = target("history", size);
    this.#gpu.clear(latest, [0, 0, 0, 1]); // read before it is written: Firefox warns of that
    return {
      size: { width, height },
      color: target("color", reduced),
      motion: target("motion", reduced, floats(this.#gpu, 4)),
      history: [latest, target("history", size)],
      key: null,
    };
  }
}

function isOfSize(one: Size, { width, height }: Size): boolean {
  return one.width === width && one.height === height;
}
