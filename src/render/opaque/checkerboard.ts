import reprojectFrag from "../../../shaders/opaque/checkerboard-reproject.frag";
import type {
  Gpu,
  Program,
  RenderTarget,
  Texture,
  TextureView,
  UniformBlock,
} from "../../gl/gpu.js";
import { clipPosition } from "../camera.js";
import type { FrameInput } from "../frame-input.js";
import type { FrameSettings } from "../frame-settings.js";
import {
  type ReprojectionSource,
  reprojectionBetween,
  reprojectionSource,
} from "../gbuffer/reprojection.js";
import { DepthPass } from "../mesh/depth-pass.js";
import { boundsOfTurned } from "../mesh/visible-runs.js";
import { SCHEDULE } from "../schedule.js";
import { screenBounds } from "../screen-bounds.js";
import { forwardComposite } from "./forward-programs.js";

/** Light of a frame: what its radiance is multiplied by, of the flame, cd, and of the moon, lx. */
interface Lighting {
  /** All but the camera that it depends on. */
  readonly key: string;
  readonly flame: number;
  readonly moon: number;
  /** Whether no shadow moves: then a pixel is kept for three frames, else for one. */
  readonly isStill: boolean;
}

/** The previous frame and the current one in turns, and their depths. */
interface KeptTargets {
  readonly previous: RenderTarget;
  readonly previousDepth: TextureView;
  readonly colors: readonly TextureView[];
  readonly depth: TextureView;
}

/**
 * Checkerboard rendering: in motion half of the pixels keep what the previous frame had, reprojected, and in still light
 * three quarters.
 *
 * A depth prepass tells where each surface was. What was not visible then, edges, and the held candle are shaded in each
 * frame. Source: El Mansouri 2016, "Rendering Rainbow Six Siege"; the composite clamps kept colours to those shaded beside
 * them, as in Karis 2014, "High Quality Temporal Supersampling".
 */
export class Checkerboard {
  readonly #gpu: Gpu;
  readonly #depthPass: DepthPass;
  /** In light that moves, and in still light. */
  readonly #reproject: readonly [Program, Program];
  /** While the camera moves. */
  #targets: KeptTargets | null = null;
  #source: ReprojectionSource | null = null;
  /** Whether all of the previous frame was shaded. */
  #isFirst = true;
  /** Which of both colours the current frame is resolved to. */
  #turn = 0;
  /** Frames that are still drawn as in motion. */
  #settling = 0;

  /** @param frame block `Frame` of a program with the same vertex shader */
  constructor(gpu: Gpu, frame: UniformBlock) {
    this.#gpu = gpu;
    // Compiled before the first step.
    this.#depthPass = new DepthPass(gpu, frame);
    const reproject = (STILL: 0 | 1) =>
      gpu.pass("opaque/checkerboard-reproject", reprojectFrag, { defines: { STILL } });
    this.#reproject = [reproject(0), reproject(1)];
    for (const isMoonlit of [false, true]) forwardComposite(gpu, isMoonlit, true);
  }

  /** Compiles what models will be drawn with in motion. */
  prepare(instances: FrameInput["instances"]): void {
    this.#depthPass.prepare(instances);
  }

  /** Settings of a frame: a few frames after motion are drawn as in it. In a slow turn the camera moves in some frames only. */
  settle(settings: FrameSettings): FrameSettings {
    const { isMoving, canDefer } = settings;
    const remaining = canDefer ? Math.max(0, this.#settling - 1) : 0;
    this.#settling = isMoving ? SCHEDULE.checkerboard.settlingFrames : remaining;
    return { ...settings, isMoving: this.#settling > 0 };
  }

  release(): void {
    const { colors, ...others } = this.#targets ?? { colors: [] };
    for (const target of [...colors, ...Object.values(others)]) target.dispose();
    this.#targets = this.#source = null;
  }

  /**
   * Draws a frame, of which what is kept is not shaded.
   *
   * @param samples what surfaces are shaded in
   * @param resolved what these are resolved to
   * @param shade draws the surfaces, tested against the depth of the samples
   * @returns radiance of the frame, and whether a part of it was kept
   */
  draw(
    frame: FrameInput,
    { key, isStill, flame, moon }: Lighting,
    samples: RenderTarget,
    resolved: RenderTarget,
    shade: () => void,
  ): { readonly radiance: Texture; readonly isKept: boolean } {
    const gpu = this.#gpu;
    const source = reprojectionSource(
      frame.instances,
      frame.clipFromWorld,
      frame.settings.features,
    );
    const current = { ...source, key: source.key + key };
    const reprojection = this.#source && reprojectionBetween(current, this.#source);
    this.#source = current;
    if (!reprojection) {
      shade();
      gpu.resolve(samples, resolved);
      this.#isFirst = true;
      return { radiance: resolved.color, isKept: false };
    }
    this.#targets ??= keptTargets(gpu, resolved);
    const { previous, colors, depth, previousDepth } = this.#targets;
    gpu.resolve(resolved, this.#isFirst ? previous : previousDepth);
    this.#turn = this.#isFirst ? 0 : 1 - this.#turn;
    const both = [resolved.color, previous.color];
    this.#depthPass.draw(frame.instances, samples);
    gpu.resolve(samples, depth);
    gpu.draw({
      program: this.#reproject[isStill ? 1 : 0],
      target: samples,
      textures: {
        uDepth: resolved.depth!,
        uPreviousRadiance: both[1 - this.#turn]!,
        uPreviousDepth: previous.depth!,
      },
      uniforms: {
        uPreviousFromCurrent: reprojection.room,
        uIsFirst: this.#isFirst ? 1 : 0,
        ...(isStill && { uIntensity: [flame, moon] }),
        uTurns: isStill ? SCHEDULE.checkerboard.stillTurns : SCHEDULE.checkerboard.turns,
        ...heldExtent(frame, resolved),
      },
      depth: "test-and-write",
    });
    shade();
    gpu.resolve(samples, colors[this.#turn]!);
    this.#isFirst = false;
    return { radiance: both[this.#turn]!, isKept: true };
  }
}

function keptTargets(gpu: Gpu, { width, height, color, depth }: RenderTarget): KeptTargets {
  const previous = gpu.renderTarget({
    label: "checkerboard/previous",
    width,
    height,
    color: ["RGBA16F"],
    depth: "texture",
  });
  const depthOf = (depth: Texture | null) =>
    gpu.textureView({ label: "checkerboard/depth", textures: [], depth: depth! });
  const colorOf = (color: Texture) => gpu.textureView({ label: "checkerboard", textures: [color] });
  return {
    previous,
    previousDepth: depthOf(previous.depth),
    colors: [colorOf(color), colorOf(previous.color)],
    depth: depthOf(depth),
  };
}

/** Bounds of what moves with the camera, pixels and metres. */
function heldExtent({ instances, clipFromWorld }: FrameInput, size: RenderTarget) {
  const held = instances.find(({ isHeld }) => isHeld);
  const bounds = { uHeldBounds: [0, 0, 0, 0], uHeldDistance: 0 };
  if (!held) return bounds;
  const clusters = held.meshes.flatMap(({ clusters }) => clusters);
  const { min, max } = boundsOfTurned(clusters, held.placement);
  const center = min.map((least, axis) => (least + max[axis]!) / 2) as [number, number, number];
  const radius = Math.max(...max.map((most, axis) => most - center[axis]!));
  const box = screenBounds([[...center, radius]], clipFromWorld, size, { margin: 0, cell: 2 });
  if (!box) return bounds;
  const [x, y, wide, high] = box;
  const [, , away] = clipPosition(clipFromWorld, ...center);
  return { uHeldBounds: [x, y, x + wide, y + high], uHeldDistance: away + Math.sqrt(3) * radius };
}
