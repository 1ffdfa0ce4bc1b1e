import displayFrag from "../../shaders/candle/display.frag";
import surfaceFrag from "../../shaders/candle/surface.frag";
import surfaceVert from "../../shaders/mesh/mesh.vert";
import type { Model } from "../assets/model.js";
import type { Gpu, RenderTarget } from "../gl/gpu.js";
import { VIBRANCE } from "../light/color.js";
import {
  carriedFlame,
  emberOverPage,
  emberRadiance,
  flameLight,
  TAPER,
} from "../light/flame-light.js";
import type { World } from "../world/world.js";
import type { FrameSettings } from "./frame-settings.js";
import { lightBlock } from "./light-block.js";
import { glareFactor, glareOf } from "./lone-candle/glare.js";
import { LoneRenderer, type SmokePassOf } from "./lone-candle/lone-renderer.js";
import { frameCandle } from "./lone-candle-framing.js";
import { surfaceSampling, uploadModel } from "./mesh/mesh.js";
import type { Tier } from "./quality.js";
import { carriedWick, FlamePass, HANDLE_TURN } from "./volumetric/flame-pass.js";

/** From cd/m² to the display's scale. */
const EXPOSURE = 5;
const EMBER = emberOverPage(EXPOSURE);
const NO_EMBER = [0, 0, 0] as const;
/** Width of candle and flame, and of glare that is more than half a step of a colour up to 7 EV, in heights of the canvas. */
const COLUMNS = 0.84;

/** What all lone candles on one context share. */
function share(gpu: Gpu, model: Model) {
  return gpu.share("lone candle", () => {
    const surfaceProgram = gpu.program("candle/surface", surfaceVert, surfaceFrag);
    return {
      surfaceProgram,
      displayProgram: gpu.pass("candle/display", displayFrag),
      frame: gpu.uniformBlock(surfaceProgram, "Frame"),
      light: gpu.uniformBlock(surfaceProgram, "Light"),
      flame: new FlamePass(gpu, true),
      candle: uploadModel(gpu, model),
      reduced: uploadModel(gpu, {
        ...model,
        parts: model.parts.map((part) => ({
          ...part,
          indices: part.reducedIndices ?? part.indices,
        })),
      }),
    };
  });
}

/** The built-in candle over the page's background. */
export class LoneCandleRenderer extends LoneRenderer {
  readonly #shared: ReturnType<typeof share>;

  constructor(gpu: Gpu, model: Model, tier: Tier, smokePass: SmokePassOf) {
    super(gpu, tier, smokePass);
    this.#shared = share(gpu, model);
  }

  protected drawFrame(world: World, settings: FrameSettings): void {
    const { frame, light, flame, displayProgram } = this.#shared;
    const { features } = settings;
    const camera = frameCandle(this.aspect, world.flame.wick);
    const drawn = this.begin(frame, camera, EXPOSURE, settings);
    light.update(lightBlock(world, features.candle, EMBER));
    if (features.candle) this.#drawCandle(drawn.target, world);
    const wick = carriedWick(world);
    if (features.volume) {
      flame.render(drawn.target, frame, wick, this.tier.physical.flameSteps);
    }
    if (features.smoke) this.drawSmoke(world, drawn, frame, TAPER.color, [wick]);
    const glare = glareOf(
      flameLight(carriedFlame(world), TAPER, EMBER),
      drawn.clip,
      glareFactor(settings),
    );
    const uniforms = { uVibrance: VIBRANCE, uGlare: glare };
    const isSmoking = features.smoke && world.plume !== null;
    this.display(displayProgram, uniforms, { Frame: frame }, isSmoking ? 1 : COLUMNS / this.aspect);
  }

  #drawCandle(target: RenderTarget, world: World): void {
    const { surfaceProgram, candle, reduced, frame, light } = this.#shared;
    const [x, y, z] = world.interpolated.foot;
    const ember = emberRadiance(world.flame.ember, EMBER);
    // A CPU shades each triangle in squares of two by two pixels.
    for (const surface of this.tier.name === "low" ? reduced : candle) {
      this.gpu.draw({
        program: surfaceProgram,
        target,
        vertexArray: surface.vertexArray,
        textures: surface.textures,
        sampling: surfaceSampling(this.tier),
        uniforms: {
          ...surface.uniforms,
          uEnvironment: TAPER.color,
          uPlacement: [x, y, z, HANDLE_TURN],
          uWax: surface.isWax ? 1 : 0,
          uEmber: surface.isWick ? ember : NO_EMBER,
        },
        blocks: { Frame: frame, Light: light },
        depth: "test-and-write",
      });
    }
  }
}
