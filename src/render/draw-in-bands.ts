import type { Draw, Gpu, RenderTarget } from "../gl/gpu.js";
import type { Steps } from "../world/steps.js";
import { bandOf } from "./screen-bounds.js";

/** A pass in bands of its target, one at each step. */
export function* drawInBands(
  gpu: Gpu,
  bands: number,
  draw: Draw & { readonly target: RenderTarget },
): Steps {
  for (let band = 0; band < bands; band++) {
    gpu.draw({ ...draw, scissor: bands > 1 ? bandOf(draw.target, band, bands) : undefined });
    yield;
  }
}
