import { expect, test } from "vitest";
import type { Draw, Gpu } from "../../../../src/gl/gpu.ts";
import { carriedWick, UPRIGHT } from "../../../../src/render/volumetric/flame-pass.ts";
import { SmokePass, smokeSpheres } from "../../../../src/render/volumetric/smoke-pass.ts";
import { advance } from "../../../../src/world/advance.ts";
import { createPlume, WICK_END } from "../../../../src/world/air/plume.ts";
import { moveCamera } from "../../../../src/world/commands.ts";
import { type Intent, STILL } from "../../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../../src/world/room/room.ts";
import type { World } from "../../../../src/world/world.ts";
import { createWorld } from "../../../support/world.ts";
import { insideOf } from "../../world/rooms.ts";

const STRAFING: Intent = { ...STILL, right: 1, runs: true };

/** A world whose candle was blown out half a second ago. */
function smoking(): World {
  const room = createRoom(new CollisionMesh([insideOf([-9, 0, -9], [9, 2.6, 9])]), null);
  const world = createWorld("physical", 1, { room, createPlume });
  world.flame.extinguish();
  advance(world, STILL, 0.5);
  return world;
}

/** The uniform that moves the youngest parcels in a frame. */
function movedIn(world: World, nodes = carriedWick(world).nodes): readonly number[] {
  let moved: unknown;
  const gpu = {
    program: () => ({}),
    uniformBlock: () => ({ update: () => {} }),
    texture: () => ({ update: () => {} }),
    buffer: () => ({}),
    vertexArray: () => ({}),
    draw: ({ uniforms }: Draw) => {
      moved = uniforms?.uMoved;
    },
  } as unknown as Gpu;
  new SmokePass(gpu, false).render(world, new Float32Array(16), {} as Draw, [{ nodes }]);
  return moved as readonly number[];
}

test.each([60, 75, 144])("smoke begins at the wick that is drawn, at %d Hz", (rate) => {
  for (const intent of [STRAFING, { ...STILL, turn: 1 }, { ...STILL, yaw: 1.5 / rate }]) {
    const world = smoking();
    let most = 0;
    for (let frame = 0; frame < rate / 2; frame++) {
      advance(world, intent, 1 / rate);
      const { root, nodes } = carriedWick(world);
      const tip = nodes.at(-1)!;
      const moved = movedIn(world);
      const [first] = [...smokeSpheres(world, [{ nodes }])].map((spheres) => [...spheres][0]);
      for (const axis of [0, 1, 2] as const) {
        expect(first?.[axis], `frame ${frame}`).toBeCloseTo(root[axis] + tip[axis], 6);
      }
      most = Math.max(most, Math.hypot(...moved));
    }
    expect(most).toBeGreaterThan(0.005);
  }
});

test("smoke of a wick at rest begins at its tip, and of one that was put elsewhere, stays behind", () => {
  const world = smoking();
  advance(world, STILL, 1 / 60);
  const fromAir = movedIn(world);
  const tip = carriedWick(world).nodes.at(-1)!;
  expect(Math.hypot(tip[0], tip[2]), "the taper's wick leans").toBeGreaterThan(0.002);
  expect(fromAir).toEqual([tip[0], tip[1] - WICK_END, tip[2]]);
  expect(movedIn(world, UPRIGHT)).toEqual([0, tip[1] - WICK_END, 0]);
  moveCamera(world, [3, 1.6, 0], 0, 0);
  expect(movedIn(world)).toEqual(fromAir);
});
