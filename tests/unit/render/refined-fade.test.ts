import { mat4 } from "gl-matrix";
import { expect, test } from "vitest";
import type { Draw, Gpu } from "../../../src/gl/gpu.js";
import type { FrameInput } from "../../../src/render/frame-input.js";
import { reprojectionSource } from "../../../src/render/gbuffer/reprojection.js";
import type { OpaqueLayer } from "../../../src/render/opaque/opaque-stage.js";
import { RefinedFade, type RefinedImage } from "../../../src/render/refinement/refined-fade.js";

const FEATURES = {} as FrameInput["settings"]["features"];
const FRAME = {
  instances: [],
  clipFromWorld: mat4.create(),
  settings: { features: FEATURES },
  world: { interpolated: { flame: [0, 0, 0] } },
} as unknown as FrameInput;
const SIZE = { width: 8, height: 8 };

/** Weights of the refined image in frames of so many seconds. */
function weights(seconds: number): number[] {
  const drawn: number[] = [];
  const gpu = {
    program: () => ({}),
    draw: ({ uniforms }: Draw) => drawn.push(Number(uniforms?.uWeight)),
  } as unknown as Gpu;
  const source = reprojectionSource([], FRAME.clipFromWorld, FEATURES);
  const fade = new RefinedFade(gpu);
  fade.begin({ textures: {}, source, flame: [0, 0, 0], light: null } as unknown as RefinedImage);
  const layer = { kind: "reduced", textures: {}, uniforms: {} } as unknown as OpaqueLayer;
  for (let i = 0; i < 100 && fade.isOn; i++) {
    fade.take(seconds);
    fade.draw(FRAME, layer, [0, 0, 8, 8], SIZE, {} as never, {} as never);
  }
  return drawn;
}

test("the refined image fades within 0.45 s, in fewer frames where they are slow", () => {
  for (const [seconds, most] of [
    [0.02, 9],
    [0.05, 9],
    [0.1, 5],
    [2, 3],
    [Number.NaN, 9],
  ] as const) {
    const drawn = weights(seconds);
    expect(drawn, `${seconds} s`).toHaveLength(most);
    expect(drawn[0], "it begins sharp").toBe(1);
    expect(drawn, "and never gets sharper").toEqual(drawn.toSorted((a, b) => b - a));
  }
});
