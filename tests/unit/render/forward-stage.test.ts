import { mat4 } from "gl-matrix";
import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import type { FrameInput } from "../../../src/render/frame-input.ts";
import type { Captures } from "../../../src/render/gi/light-captures.ts";
import { ForwardStage } from "../../../src/render/opaque/forward-stage.ts";
import { tierNamed } from "../../../src/render/quality.ts";
import { createWorld } from "../../../src/world/create-world.ts";
import { finish } from "../../../src/world/steps.ts";

const SIZE = { width: 96, height: 54 };

/** As much of a GPU as draws no surfaces. */
function createGpu(): Gpu {
  const dispose = () => {};
  const target = ({ label }: { label: string }) => ({
    ...SIZE,
    color: { label, dispose },
    depth: { label, dispose },
    dispose,
  });
  const nothing = () => {};
  return {
    renderer: "A GPU",
    drawsToFloats: true,
    program: () => ({ isCompiled: true }),
    pass: () => ({ isCompiled: true }),
    uniformBlock: () => ({ update: nothing }),
    share: () => ({}),
    renderTarget: target,
    textureView: target,
    clear: nothing,
    resolve: nothing,
    draw: nothing,
  } as unknown as Gpu;
}

test("a moving frame from the same place shows no frame of which a part was kept and not clamped", () => {
  const stage = new ForwardStage(createGpu(), tierNamed("medium"));
  stage.resize(SIZE);
  const world = createWorld("physical", 1);
  const captures = {
    shadow: { depth: {}, captureOrigin: [0, 0, 0] },
    irradiance: { textures: {}, surfels: {}, block: {}, revision: 0 },
    cached: [],
  } as unknown as Captures;
  const shownFrom = (x: number) => {
    const clipFromWorld = mat4.perspective(mat4.create(), 1, 16 / 9, 0.1, 100);
    mat4.translate(clipFromWorld, clipFromWorld, [x, 0, 0]);
    const frame = {
      world,
      settings: { features: {}, inspect: "picture", isMoving: true, canDefer: true },
      clipFromWorld,
      instances: [],
    } as unknown as FrameInput;
    const { textures } = finish(stage.shade(frame, captures));
    return (textures.uRadiance as unknown as { label: string }).label;
  };
  expect([0, 0.01, 0.02, 0.02].map(shownFrom)).toEqual([
    "forward/radiance",
    "checkerboard/previous",
    "checkerboard/previous",
    "checkerboard/previous",
  ]);
});
