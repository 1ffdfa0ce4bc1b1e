import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { CachedSurfaces } from "../../../src/render/lone-candle/cached-surfaces.ts";

/** Images of surfaces in one light, and how often they were begun. */
function cachedSurfaces() {
  let begun = 0;
  const target = ({ width, height }: { width: number; height: number }) => ({
    color: { width, height },
    dispose() {},
  });
  const gpu = { renderTarget: target, clear() {}, resolve() {} } as unknown as Gpu;
  const surfaces = new CachedSurfaces(gpu, (_, __, [, bottom]) => {
    if (bottom === 0) begun++;
  });
  /** Draws all that is missing. The width of the image. */
  const drawnAt = (edge: number) => {
    while (!surfaces.proceed({ width: edge, height: edge }, ["light"])) {}
    return surfaces.images[0]?.width;
  };
  return { drawnAt, begun: () => begun };
}

test("Images of a candle that is shown smaller are drawn anew where they are more than twice as large", () => {
  const { drawnAt } = cachedSurfaces();
  expect([900, 600, 450].map(drawnAt)).toEqual([900, 900, 900]);
  expect(drawnAt(120)).toBe(120);
});

test("While a candle shrinks its images are drawn anew at each halving alone", () => {
  const { drawnAt, begun } = cachedSurfaces();
  for (let edge = 900; edge >= 120; edge -= 3) drawnAt(edge);
  expect(begun()).toBe(3);
});
