import type { Box } from "./draw-commands.js";
import type { RenderTarget } from "./render-target.js";
import type { TextureView } from "./texture-view.js";

/** Pixels of the canvas, 8-bit RGBA, rows from the bottom up. */
export function readCanvas(gl: WebGL2RenderingContext, [x, y, width, height]: Box): Uint8Array {
  const pixels = new Uint8Array(width * height * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** RGB of a floating-point target, rows from the top. */
export function readFloats(
  gl: WebGL2RenderingContext,
  target: RenderTarget | TextureView,
  [x, y, width, height]: Box,
): Float32Array {
  const texels = new Float32Array(width * height * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
  gl.readPixels(x, target.height - y - height, width, height, gl.RGBA, gl.FLOAT, texels);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const rgb = new Float32Array(width * height * 3);
  for (let i = 0; i < width * height; i++) {
    const from = (i + width * (height - 1 - 2 * Math.floor(i / width))) * 4;
    rgb.set(texels.subarray(from, from + 3), i * 3);
  }
  return rgb;
}
