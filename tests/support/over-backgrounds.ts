import { mat4 } from "gl-matrix";
import dustVert from "../../shaders/volumetric/dust.vert";
import moteFrag from "../../shaders/volumetric/mote.frag";
import { type Box, type Draw, Gpu } from "../../src/gl/gpu.ts";
import type { Texture } from "../../src/gl/texture.ts";
import type { TextureView } from "../../src/gl/texture-view.ts";
import { clipFromWorld, projectionScale } from "../../src/render/camera.ts";
import type { IrradianceVolume } from "../../src/render/gi/irradiance-volume.ts";
import { lightBlock } from "../../src/render/light-block.ts";
import { tierNamed } from "../../src/render/quality.ts";
import { carriedWick, FlamePass } from "../../src/render/volumetric/flame-pass.ts";
import { MotesPass } from "../../src/render/volumetric/motes-pass.ts";
import { FEEDBACK } from "../../src/render/volumetric/particle-system.ts";
import { SmokePass } from "../../src/render/volumetric/smoke-pass.ts";
import { advance } from "../../src/world/advance.ts";
import { createPlume } from "../../src/world/air/plume.ts";
import type { Vec3 } from "../../src/world/geometry.ts";
import { STILL } from "../../src/world/player/intent.ts";
import { createWorld } from "./world.ts";

const [WIDTH, HEIGHT] = [160, 90];
/** Where the eye is, from the flame's foot, m, and its field of view. */
const EYE = [0, 0.04, 0.35] as const;
const FIELD = 0.5;
/** The camera's planes, m: shaders/lib/depth.glsl. */
const [NEAR, FAR] = [0.05, 60];

/** How a draw changes what is behind it, in all pixels that it touches. */
export interface Mixture {
  readonly pixels: number;
  /** What it adds at most, cd/m². */
  readonly most: number;
  /** Largest share that it takes of what is behind. */
  readonly opacity: number;
  /** Largest error of: added + (1 - opacity) x what is behind, as a share of that, over another background. */
  readonly error: number;
  /**
   * Shares of what its plainest pixel adds, as a surface that hides it goes away by a tenth of `reach` at a
   * time, from where it first shows. Empty where it reads no depth.
   */
  readonly fading: readonly number[];
}

/** Repeats one draw, as its pass declared it, before backgrounds of one colour and surfaces at one distance. */
class Repeater {
  readonly #gpu: Gpu;
  readonly #target: TextureView;
  readonly #draw: Draw;

  constructor(gpu: Gpu, draw: Draw, target: TextureView) {
    this.#gpu = gpu;
    this.#draw = draw;
    this.#target = target;
  }

  /** Radiance over a background of so much red, green and blue, cd/m². */
  over(background: number, distance = FAR, box: Box = [0, 0, WIDTH, HEIGHT]): Float32Array {
    const uDepth = surfaceAt(this.#gpu, distance);
    this.#gpu.clear(this.#target, [background, background, background, 1]);
    const textures = { ...this.#draw.textures, uDepth };
    this.#gpu.draw({ ...this.#draw, textures, target: this.#target, into: undefined });
    uDepth.dispose();
    return this.#gpu.readFloats(this.#target, box);
  }
}

function surfaceAt(gpu: Gpu, distance: number): Texture {
  const depth = (FAR / (FAR - NEAR)) * (1 - NEAR / distance);
  const data = new Float32Array(WIDTH * HEIGHT).fill(depth);
  const source = { width: WIDTH, height: HEIGHT, data };
  return gpu.texture({ label: "surface", format: "R32F", source, filter: "nearest" });
}

function mixtureOf(repeater: Repeater, reach: number): Mixture {
  const added = repeater.over(0);
  const most = added.reduce((most, value) => Math.max(most, value), 0);
  const before = repeater.over(most);
  const other = repeater.over(3 * most);
  let [pixels, opacity, error, plainest] = [0, 0, 0, 0];
  for (let i = 0; i < added.length; i++) {
    const isTouched = before[i] !== most;
    if (!isTouched) continue;
    if (i % 3 === 0) pixels++;
    const taken = 1 - (before[i]! - added[i]!) / most;
    opacity = Math.max(opacity, taken);
    const expected = added[i]! + (1 - taken) * 3 * most;
    error = Math.max(error, Math.abs(other[i]! / expected - 1));
    if (added[i]! > added[plainest]!) plainest = i;
  }
  const fading = reach > 0 ? fadingIn(repeater, Math.floor(plainest / 3), reach) : [];
  return { pixels, most, opacity, error, fading };
}

function fadingIn(repeater: Repeater, pixel: number, reach: number): number[] {
  const box = [pixel % WIDTH, Math.floor(pixel / WIDTH), 1, 1] as const;
  const at = (distance: number) => repeater.over(0, distance, box)[0] ?? 0;
  const whole = at(FAR);
  let [hidden, shown] = [NEAR, 10];
  while (shown - hidden > 1e-5) {
    const middle = (hidden + shown) / 2;
    if (at(middle) > 0) shown = middle;
    else hidden = middle;
  }
  return Array.from({ length: 16 }, (_, i) => at(hidden + ((i - 1) * reach) / 10) / whole);
}

/** A block as the passes' programs declare it. */
function blockOf(gpu: Gpu, name: "Frame" | "Light" | "Volume") {
  const dust = gpu.program("volumetric/dust", dustVert, moteFrag, { feedback: FEEDBACK });
  return gpu.uniformBlock(dust, name);
}

/** A room that throws nothing back, for passes that ask what it does. */
function darkRoom(gpu: Gpu, uDark: Texture): IrradianceVolume {
  const block = blockOf(gpu, "Volume");
  const one = { columns: 1, rows: 1, planes: 1, inset: 0.5, bias: 0 };
  block.update({ corner: [0, 0, 0], extent: [1, 1, 1], ...one });
  return {
    block,
    textures: { uIrradiance: uDark, uProbePositions: uDark, uProbeDepth: uDark },
    surfels: { uSurfelNormalDistance: uDark, uTotalRadiosity: uDark },
    support: uDark,
    revision: 0,
    roomReflectance: uDark,
  };
}

/**
 * How flame, sparks, dust and smoke of a candle are mixed with what is behind them. Each
 * draw is one that its pass makes, repeated before other backgrounds. Runs in the browser.
 *
 * @param seed of a candle whose wick spits, and after how many seconds
 */
export function mixtures(seed: number, seconds: number) {
  const gpu = new Gpu(document.createElement("canvas"));
  const passes = {
    flame: new FlamePass(gpu),
    motes: new MotesPass(gpu),
    smoke: new SmokePass(gpu, false),
  };
  const color = gpu.texture({
    label: "background",
    format: "RGBA32F",
    source: { width: WIDTH, height: HEIGHT },
  });
  const target = gpu.textureView({ label: "background", textures: [color], image: 0 });
  const depth = surfaceAt(gpu, FAR);
  const veil = { target, depth };
  const dark = { width: 1, height: 1, data: new Float32Array(4) };
  const volume = darkRoom(gpu, gpu.texture({ label: "dark", format: "RGBA32F", source: dark }));
  const [frame, light] = [blockOf(gpu, "Frame"), blockOf(gpu, "Light")];

  const world = createWorld("physical", seed, { createPlume });
  passes.motes.setLayers(world, world.setup.layers);
  const clip = mat4.create();
  const look = () => {
    const [x, y, z] = world.interpolated.flame;
    const eye: Vec3 = [x + EYE[0], y + EYE[1], z + EYE[2]];
    frame.update({
      clipFromWorld: mat4.copy(clip, clipFromWorld(eye, 0, 0, WIDTH / HEIGHT, FIELD)),
      eyePosition: eye,
      exposure: 1,
      viewport: [WIDTH, HEIGHT],
      projectionScale: projectionScale(Math.min(WIDTH, HEIGHT), FIELD),
      normalMaps: 1,
    });
    light.update(lightBlock(world, true));
  };
  /** What a pass draws, repeated. */
  const repeated = (reach: number, render: () => void): Mixture => {
    const drawn: Draw[] = [];
    gpu.draw = (draw) => {
      // What makes vertices goes on.
      if (draw.target) drawn.push(draw);
      else Gpu.prototype.draw.call(gpu, draw);
    };
    render();
    Reflect.deleteProperty(gpu, "draw");
    const [draw] = drawn;
    if (!draw || drawn.length > 1) throw new Error(`The pass made ${drawn.length} draws.`);
    return mixtureOf(new Repeater(gpu, draw, target), reach);
  };

  advance(world, STILL, seconds);
  look();
  const flame = repeated(0, () =>
    passes.flame.render(target, frame, carriedWick(world), tierNamed("medium").physical.flameSteps),
  );
  const motes = (name: "dust" | "spark") =>
    repeated(0.01, () => passes.motes.render(name, veil, world, frame, light, volume, [0, 0, 0]));
  const dust = motes("dust");
  const spark = motes("spark");
  world.flame.extinguish();
  advance(world, STILL, 1);
  look();
  const smoke = repeated(0.03, () =>
    passes.smoke.render(
      world,
      clip,
      {
        target,
        textures: { uDepth: depth, ...volume.textures },
        blocks: { Frame: frame, Light: light, Volume: volume.block },
      },
      [carriedWick(world)],
    ),
  );
  gpu.dispose();
  return { flame, dust, spark, smoke };
}
