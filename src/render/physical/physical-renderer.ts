import displayFrag from "../../../shaders/physical/display.frag";
import flameFrag from "../../../shaders/physical/flame.frag";
import flameVert from "../../../shaders/physical/flame.vert";
import fullscreenVert from "../../../shaders/physical/fullscreen.vert";
import surfaceFrag from "../../../shaders/physical/surface.frag";
import surfaceVert from "../../../shaders/physical/surface.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { adaptation } from "../../light/color.js";
import { BODY_SIZE, outline } from "../../light/flame-body.js";
import { flameLight, TAPER } from "../../light/flame-light.js";
import type { World } from "../../world/world.js";
import { clipFromWorld, projectionScale } from "../camera.js";
import type { Models, Renderer } from "../renderer.js";
import { type Surface, uploadModel } from "../surface.js";
import type { Tier } from "../tier.js";
import type { View } from "../view.js";
import { BloomPass } from "./bloom-pass.js";
import { type IndirectDetail, IndirectPass, type IrradianceVolume } from "./indirect-pass.js";
import { ShadowPass } from "./shadow-pass.js";

/** From cd/m² to the display's scale, where middle grey is 0.18: a wall of 0.08 cd/m² lands there. */
const EXPOSURE = 5;
/** Steps of the march through the flame. */
const FLAME_STEPS: Readonly<Record<Tier["name"], number>> = {
  low: 12,
  medium: 24,
  high: 40,
  ultra: 64,
};
/** Shadow cube: texels along an edge, taps that look for what casts it, taps that soften it. */
const SHADOW: Readonly<Record<Tier["name"], { size: number; search: number; taps: number }>> = {
  low: { size: 128, search: 4, taps: 6 },
  medium: { size: 512, search: 8, taps: 12 },
  high: { size: 512, search: 8, taps: 20 },
  ultra: { size: 1024, search: 16, taps: 32 },
};
const INDIRECT: Readonly<Record<Tier["name"], IndirectDetail>> = {
  low: { patches: 6, probes: [5, 3, 5], bounces: 5 },
  medium: { patches: 8, probes: [6, 4, 6], bounces: 6 },
  high: { patches: 16, probes: [8, 6, 8], bounces: 8 },
  ultra: { patches: 16, probes: [10, 6, 10], bounces: 10 },
};
const BLOOM_LEVELS: Readonly<Record<Tier["name"], number>> = {
  low: 3,
  medium: 5,
  high: 6,
  ultra: 6,
};
/** Share of the light that the eye and the lens scatter. */
const SCATTERED = 0.0006;
/** The ring handle, along +X in the model, is turned towards the visitor's right hand. */
const HANDLE_TURN = -1.1;
/** What of the chamberstick stands in its own light: heights above its foot and radii, metres. */
const CANDLE = { rim: 0.2015, rimRadius: 0.0105, pan: 0.018, panRadius: 0.066 } as const;
const BLACK = [0, 0, 0, 1] as const;

/**
 * The room as a real flame lights it, in candela and metres: linear and high in range until `display`.
 */
export class PhysicalRenderer implements Renderer {
  readonly particles = 0;
  readonly #gpu: Gpu;
  readonly #tier: Tier;
  readonly #surfaceProgram: Program;
  readonly #flameProgram: Program;
  readonly #displayProgram: Program;
  readonly #frame: UniformBlock;
  readonly #light: UniformBlock;
  readonly #flame: UniformBlock;
  readonly #shadow: ShadowPass;
  readonly #indirect: IndirectPass;
  readonly #bloom: BloomPass;
  readonly #room: readonly Surface[];
  readonly #candle: readonly Surface[];
  readonly #body: Texture;
  readonly #outline: Texture;
  readonly #hull: VertexArray;
  readonly #screen: VertexArray;
  readonly #adaptation = adaptation(TAPER.color);
  #samples: RenderTarget | null = null;
  #radiance: RenderTarget | null = null;
  #size = { width: 1, height: 1 };

  constructor(gpu: Gpu, { room, candle }: Models, tier: Tier) {
    this.#gpu = gpu;
    this.#tier = tier;
    this.#surfaceProgram = gpu.program("physical/surface", surfaceVert, surfaceFrag, {
      defines: { SHADOW_SEARCH: SHADOW[tier.name].search, SHADOW_TAPS: SHADOW[tier.name].taps },
    });
    this.#shadow = new ShadowPass(gpu, SHADOW[tier.name].size);
    this.#flameProgram = gpu.program("physical/flame", flameVert, flameFrag);
    this.#displayProgram = gpu.program("physical/display", fullscreenVert, displayFrag);
    this.#frame = gpu.uniformBlock(this.#surfaceProgram, "Frame");
    this.#light = gpu.uniformBlock(this.#surfaceProgram, "Light");
    this.#flame = gpu.uniformBlock(this.#flameProgram, "Flame");
    this.#room = uploadModel(gpu, room, tier);
    this.#candle = uploadModel(gpu, candle, tier);
    this.#body = gpu.texture({
      label: "flame/body",
      format: "RGBA32F",
      source: { ...BODY_SIZE, data: TAPER.texels },
    });
    this.#outline = gpu.texture({
      label: "flame/outline",
      format: "R32F",
      source: {
        width: BODY_SIZE.height,
        height: 1,
        data: Float32Array.from({ length: BODY_SIZE.height }, (_, i) =>
          outline((i + 0.5) / BODY_SIZE.height),
        ),
      },
    });
    this.#hull = gpu.vertexArray("flame/hull", { attributes: {}, count: 14 });
    this.#screen = gpu.vertexArray("screen", { attributes: {}, count: 3 });
    this.#indirect = new IndirectPass(gpu, this.#screen, room.bounds, INDIRECT[tier.name]);
    this.#bloom = new BloomPass(gpu, this.#screen, BLOOM_LEVELS[tier.name]);
  }

  resize(width: number, height: number): void {
    const { samples } = this.#tier;
    this.#size = { width, height };
    this.#samples?.dispose();
    this.#radiance?.dispose();
    const size = { width, height, color: ["RGBA16F"] as const, depth: "buffer" as const };
    this.#samples =
      samples > 1 ? this.#gpu.renderTarget({ label: "frame samples", ...size, samples }) : null;
    this.#radiance = this.#gpu.renderTarget({ label: "radiance", ...size });
    this.#bloom.resize(width, height);
  }

  /** The body of the flame is no particles. */
  follow(): void {}

  render(world: World, view: View): void {
    if (!this.#radiance) return;
    const target = this.#samples ?? this.#radiance;
    this.#updateBlocks(world, view);
    const { position } = flameLight(world, TAPER);
    const shadow = this.#shadow.render(this.#room, position);
    const volume = this.#indirect.render(this.#room, this.#light, position);
    this.#gpu.clear(target, BLACK);
    this.#drawSurfaces(target, this.#room, shadow, volume, [0, 0, 0, 0]);
    if (view.features.candle) {
      const [x, y, z] = world.shown.foot;
      this.#drawSurfaces(target, this.#candle, shadow, volume, [
        x,
        y,
        z,
        world.candle.yaw + HANDLE_TURN,
      ]);
    }
    this.#drawFlame(target);
    if (this.#samples) this.#gpu.resolve(this.#samples, this.#radiance);
    const radiance = this.#radiance.color;
    const bloom = this.#bloom.render(radiance);
    this.#gpu.draw({
      program: this.#displayProgram,
      target: "canvas",
      vertexArray: this.#screen,
      textures: { uRadiance: radiance, uBloom: bloom },
      uniforms: {
        uAdaptation: this.#adaptation,
        uScattered: view.features.bloom ? SCATTERED : 0,
      },
      blocks: { Frame: this.#frame },
    });
  }

  #updateBlocks(world: World, { features, exposure }: View): void {
    const { player, shown, stage } = world;
    const { width, height } = this.#size;
    this.#frame.update({
      clipFromWorld: clipFromWorld(
        shown.eye,
        player.yaw,
        player.pitch,
        width / height,
        stage.fieldOfView,
      ),
      eyePosition: shown.eye,
      exposure: EXPOSURE * 2 ** exposure,
      viewport: [width, height],
      projectionScale: projectionScale(height),
      normalMaps: features.normalMaps ? 1 : 0,
    });
    const light = flameLight(world, TAPER);
    this.#light.update({
      position: light.position,
      halfHeight: light.halfHeight,
      intensity: light.intensity,
      radius: light.radius,
      axis: [shown.foot[0], shown.foot[2]],
      rim: shown.foot[1] + CANDLE.rim,
      rimRadius: features.candle ? CANDLE.rimRadius : 0,
      pan: shown.foot[1] + CANDLE.pan,
      panRadius: features.candle ? CANDLE.panRadius : 0,
    });
    const [x, y, z] = shown.flame;
    this.#flame.update({
      base: [x, y, z],
      radius: TAPER.radius,
      tip: [x, y + TAPER.height, z],
      steps: FLAME_STEPS[this.#tier.name],
    });
  }

  #drawSurfaces(
    target: RenderTarget,
    surfaces: readonly Surface[],
    shadow: Texture,
    volume: IrradianceVolume,
    place: readonly [number, number, number, number],
  ): void {
    for (const {
      vertexArray,
      textures,
      baseColor,
      parameters,
      isDoubleSided,
      isWax,
      occlusionStrength,
    } of surfaces) {
      this.#gpu.draw({
        program: this.#surfaceProgram,
        target,
        vertexArray,
        textures: { ...textures, uShadow: shadow, ...volume.textures },
        uniforms: {
          uBaseColor: baseColor,
          uPlace: place,
          uSurface: parameters,
          uOcclusion: occlusionStrength,
          uWax: isWax ? 1 : 0,
        },
        blocks: { Frame: this.#frame, Light: this.#light, Volume: volume.block },
        depth: "test-and-write",
        cull: isDoubleSided ? "none" : "back",
      });
    }
  }

  #drawFlame(target: RenderTarget): void {
    this.#gpu.draw({
      program: this.#flameProgram,
      target,
      vertexArray: this.#hull,
      primitive: "strip",
      textures: { uBody: this.#body, uOutline: this.#outline },
      blocks: { Frame: this.#frame, Flame: this.#flame },
      blend: "premultiplied",
      depth: "test",
      cull: "none",
    });
  }

  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    if (!this.#radiance) return new Float32Array(width * height * 3);
    return this.#gpu.readRadiance(this.#radiance, x, y, width, height);
  }
}
