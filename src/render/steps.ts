import type { Draw, Gpu } from "../gl/gpu.js";
import type { RenderTarget } from "../gl/render-target.js";
import { bandOf } from "./screen-bounds.js";

/** Work in steps, of which each frame does a few. */
export type Steps<Result = void> = Generator<void, Result>;

/** All of the steps at once. */
export function finish<Result>(steps: Steps<Result>): Result {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}

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
