import type { CandleFlameElement, Look } from "../candle-flame-element.js";

let drawsFloats: boolean | null = null;

/** Look that an element draws: the paper's in place of `physical` where targets cannot hold floats. */
export function drawnLook({ look }: CandleFlameElement): Look {
  if (look !== "physical") return look;
  drawsFloats ??= hasFloatTargets();
  return drawsFloats ? look : "paper";
}

function hasFloatTargets(): boolean {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2");
  const names = ["EXT_color_buffer_float", "EXT_color_buffer_half_float"];
  const hasOne = names.some((name) => gl?.getExtension(name));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return hasOne;
}
