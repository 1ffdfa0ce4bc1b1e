import type { Gpu, RenderTarget } from "../gl/gpu.js";

/** A target that is known, if it has the size that is asked for; else a new one in its place. */
export function fittedTarget(
  gpu: Gpu,
  known: RenderTarget | null,
  options: Parameters<Gpu["renderTarget"]>[0],
): RenderTarget {
  if (known?.width === options.width && known.height === options.height) return known;
  known?.dispose();
  return gpu.renderTarget(options);
}
