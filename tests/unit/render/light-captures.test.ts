import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import type { FrameInput } from "../../../src/render/frame-input.ts";
import { LightCaptures } from "../../../src/render/gi/light-captures.ts";
import { captureLight } from "../../../src/render/light-block.ts";
import { tierNamed } from "../../../src/render/quality.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { finish } from "../../../src/world/steps.ts";
import { createWorld } from "../../support/world.ts";
import { box, modelOf } from "./boxes.ts";

/** As much of a GPU as draws nothing. What it makes has any property that it is asked for. */
function createGpu(): Gpu {
  const thing: unknown = new Proxy(() => thing, {
    get: (_, name) => (name === Symbol.toPrimitive ? () => 1 : thing),
  });
  const known = {
    used: new Set(),
    isCompiling: false,
    share: (_: object, make: () => object) => make(),
  };
  return new Proxy(known, {
    get: (_, name) => Reflect.get(known, name) ?? (() => thing),
  }) as unknown as Gpu;
}

test("held light is given up where another light's shadows take its place", () => {
  const room = box([0, 0, 0], [4, 2, 4], false);
  const scene = { model: modelOf(room), collision: new CollisionMesh([room]), surfaces: [] };
  const captures = new LightCaptures(createGpu(), scene, tierNamed("low").physical, false);
  const world = createWorld("physical", 1);
  const frameAt = (position: Vec3) =>
    ({
      world,
      captureLight: { ...captureLight(world, true), position },
      settings: { canDefer: false, isMoving: false },
    }) as unknown as FrameInput;
  const originOf = (frame: FrameInput) => captures.update(frame, "full").shadow.captureOrigin;
  const [first, near, beyond] = [0, 0.004, 0.008].map((x) => frameAt([x, 1, 0])) as [
    FrameInput,
    FrameInput,
    FrameInput,
  ];
  for (let tries = 0; !captures.hold(first, 1e6); tries++) expect(tries).toBeLessThan(100);
  expect(originOf(near), "held").toEqual([0, 1, 0]);
  finish(captures.shadow(near.captureLight));
  expect(originOf(near), "and it serves").toEqual([0, 1, 0]);
  finish(captures.shadow(beyond.captureLight));
  expect(originOf(beyond)).toEqual([0.008, 1, 0]);
});
