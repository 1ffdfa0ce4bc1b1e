import { expect, test } from "../support/test.ts";

test("Pixels come from SwiftShader, the same on every machine", async ({ room }) => {
  const renderer = await room.evaluate((element) => {
    const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
    const names = gl?.getExtension("WEBGL_debug_renderer_info");
    return names ? String(gl?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  });
  expect(renderer).toContain("SwiftShader");
});

test("WebGL 2 draws as asked", async ({ page }) => {
  const { version, pixel } = await page.evaluate(() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return { version: "none", pixel: [] };
    gl.clearColor(1, 0.5, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return { version: String(gl.getParameter(gl.VERSION)), pixel: [...pixel] };
  });
  expect(version).toContain("WebGL 2.0");
  expect(pixel).toEqual([255, 128, 0, 255]);
});
