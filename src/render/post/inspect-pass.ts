import displayVert from "../../../shaders/post/display.vert";
import inspectFrag from "../../../shaders/post/inspect.frag";
import type { Gpu, Program, Texture, UniformBlock } from "../../gl/gpu.js";
import { ADAPTATION } from "../../light/flame-light.js";
import type { Inspection } from "../../settings.js";
import type { FrameSettings } from "../frame-settings.js";
import type { IrradianceVolume } from "../gi/irradiance-volume.js";

/** Numbers of the views in `post/inspect.frag`. */
const VIEWS: Readonly<Record<Exclude<Inspection, "picture">, number>> = {
  radiance: 0,
  exposure: 1,
  bloom: 2,
  depth: 3,
  "shadow-cube": 4,
  "irradiance-volume": 5,
  soot: 6,
  blue: 6,
  temperature: 7,
  normals: 8,
  haze: 8,
};
/** Luminance shown as white in views of a part of the flame, cd/m². */
const WHITE_LUMINANCE = { soot: 12_000, blue: 80 } as const;

/** Inspection: a pass's result in place of the frame, on a canvas in sRGB. */
export class InspectPass {
  readonly #gpu: Gpu;
  readonly #program: Program;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#program = gpu.program("post/inspect", displayVert, inspectFrag);
  }

  render(
    { inspect, features }: Pick<FrameSettings, "inspect" | "features">,
    passes: Readonly<Record<"uRadiance" | "uBloom" | "uExposure" | "uDepth" | "uShadow", Texture>>,
    volume: IrradianceVolume,
    blocks: Readonly<Record<"Frame" | "Light", UniformBlock>>,
  ): void {
    if (inspect === "picture") return;
    this.#gpu.setColorSpace("srgb");
    this.#gpu.draw({
      program: this.#program,
      target: "canvas",
      textures: { ...passes, uIrradiance: volume.textures.uIrradiance },
      uniforms: {
        uView: VIEWS[inspect],
        uAdaptation: ADAPTATION,
        uAutoExposure: features.autoExposure ? 1 : 0,
        uWhiteLuminance: inspect === "blue" ? WHITE_LUMINANCE.blue : WHITE_LUMINANCE.soot,
      },
      blocks: { ...blocks, Volume: volume.block },
    });
  }
}
