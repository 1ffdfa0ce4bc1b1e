import { resolve } from "node:path";
import sharp from "sharp";
import { expect, test } from "vitest";
import { luma } from "../../../src/light/color.ts";
import { decode } from "../../support/flash.ts";
import { textOf } from "../sources.js";

// No measured coefficients of candle wax were found: the band is what pillars look like.
test.each([
  ["a taper", "lib/wax.glsl", "DIFFUSION_LENGTH"],
  ["a pillar", "candle/custom-surface.frag", "PILLAR_DIFFUSION_LENGTH"],
])(
  "wax of %s glows down to 1/e in 6 to 16 mm of red light, and 1.3 to 2.5 times as far as in blue",
  (_, file, name) => {
    expect(textOf("shaders/lib/wax.glsl")).toContain(
      "exp(-max(light.rim - position.y, 0.0) / diffusionLength)",
    );
    const [, text = ""] =
      new RegExp(`${name} = vec3\\(([^)]*)\\)`).exec(textOf(`shaders/${file}`)) ?? [];
    const [red = 0, , blue = 0] = text.split(",").map(Number);
    expect(red).toBeGreaterThan(0.006);
    expect(red).toBeLessThan(0.016);
    expect(red / blue).toBeGreaterThan(1.3);
    expect(red / blue).toBeLessThan(2.5);
  },
);

test("white wax throws 0.7 to 0.9 of the light back", async () => {
  const file = resolve(import.meta.dirname, "../../../public/textures/wax-albedo.avif");
  const { data, info } = await sharp(file)
    .removeAlpha()
    .raw()
    .toBuffer({ resolveWithObject: true });
  let sum = 0;
  for (let i = 0; i < data.length; i += 3) {
    sum += luma([0, 1, 2].map((k) => decode(data[i + k] ?? 0)) as [number, number, number]);
  }
  const albedo = sum / (info.width * info.height);
  expect(albedo).toBeGreaterThan(0.7);
  expect(albedo).toBeLessThan(0.9);
});
