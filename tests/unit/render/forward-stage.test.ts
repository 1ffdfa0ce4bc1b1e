import { mat4 } from "gl-matrix";
import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { AT_ORIGIN, type FrameInput } from "../../../src/render/frame-input.ts";
import type { Captures } from "../../../src/render/gi/light-captures.ts";
import { ForwardStage } from "../../../src/render/opaque/forward-stage.ts";
import { tierNamed } from "../../../src/render/quality.ts";
import type { CompositedFrame } from "../../../src/render/volumetric/volumetric-target.ts";
import { finish } from "../../../src/world/steps.ts";
import { createWorld } from "../../support/world.ts";

const SIZE = { width: 96, height: 54 };

const CAPTURES = {
  shadow: { depth: {}, captureOrigin: [0, 0, 0] },
  irradiance: { textures: {}, surfels: {}, block: {}, revision: 0 },
  cached: [],
} as unknown as Captures;

type Defines = Readonly<Record<string, number>>;

/** As much of a GPU as draws no surfaces. `draws`: what each draw's program was defined with. */
function createGpu(draws: Defines[], asked: string[] = []): Gpu {
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
    program: (label: string, _vertex: string, _fragment: string, { defines = {} } = {}) => {
      asked.push(JSON.stringify([label, defines]));
      return { isCompiled: true, defines };
    },
    pass: (_label: string, _shader: string, { defines = {} } = {}) => ({ defines }),
    uniformBlock: () => ({ update: nothing }),
    share: () => ({}),
    renderTarget: target,
    textureView: target,
    clear: nothing,
    resolve: nothing,
    draw: ({ program }: { program: { defines: Defines } }) => draws.push(program.defines),
  } as unknown as Gpu;
}

test("what a moving frame keeps is clamped, also where the camera is still", () => {
  const draws: Defines[] = [];
  const stage = new ForwardStage(createGpu(draws), tierNamed("medium"));
  stage.resize(SIZE);
  const world = createWorld("physical", 1);
  const isClampedFrom = (x: number) => {
    const clipFromWorld = mat4.perspective(mat4.create(), 1, 16 / 9, 0.1, 100);
    mat4.translate(clipFromWorld, clipFromWorld, [x, 0, 0]);
    const frame = {
      world,
      settings: { features: {}, inspect: "picture", isMoving: true, canDefer: true },
      clipFromWorld,
      instances: [],
    } as unknown as FrameInput;
    const layer = finish(stage.shade(frame, CAPTURES));
    stage.composite(frame, layer, { target: {} } as CompositedFrame, [0, 0, 1, 1]);
    return draws.at(-1)?.KEPT === 1;
  };
  expect([0, 0.01, 0.02, 0.02].map(isClampedFrom)).toEqual([false, true, true, true]);
});

test("the depth prepass of meshes with holes is compiled before the first frame in motion", () => {
  const asked: string[] = [];
  const stage = new ForwardStage(createGpu([], asked), tierNamed("medium"));
  stage.resize(SIZE);
  const shade = (alphaCutoff: number) => {
    const mesh = {
      isCutOut: alphaCutoff > 0,
      uniforms: { uSurface: [1, 0, 1, alphaCutoff] },
      clusters: [],
    };
    const frame = {
      world: createWorld("physical", 1),
      settings: { features: {}, inspect: "picture", isMoving: false, canDefer: true },
      clipFromWorld: mat4.create(),
      instances: [{ meshes: [mesh], placement: AT_ORIGIN, isHeld: false }],
    } as unknown as FrameInput;
    finish(stage.shade(frame, CAPTURES));
    return asked.filter((program) => /mesh.depth.*CUTOUT/.test(program)).length;
  };
  expect([0, 0.5, 0.5].map(shade)).toEqual([0, 1, 1]);
});
