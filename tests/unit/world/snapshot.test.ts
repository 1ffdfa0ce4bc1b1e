import { expect, test } from "vitest";
import { advance } from "../../../src/world/advance.ts";
import { moveCamera, placeCandle } from "../../../src/world/commands.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import { restoreSnapshot, takeSnapshot, timeOf } from "../../../src/world/snapshot.ts";
import { currentTime } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";
import { box, floorOf } from "./rooms.ts";

const room = () =>
  createRoom(new CollisionMesh([floorOf(8), box([-0.5, 0, -1.4], [0.5, 0.8, -0.7])]), null);

test.each(["physical", "paper"] as const)("a %s world goes on from a moment of another", (look) => {
  const birth = look === "physical" ? { room: room() } : {};
  const gone = createWorld(look, 1, birth);
  advance(gone, { ...STILL, forward: 1, turn: 0.3 }, 0.3);
  expect(placeCandle(gone)).toBe(true);
  advance(gone, { ...STILL, forward: -1, turn: 0.5, togglesFlame: true }, 0.205);
  moveCamera(gone, gone.player.position, gone.player.yaw, -0.1, 1.2);
  const moment = takeSnapshot(gone);
  expect(moment.fieldOfView).toBe(1.2);
  expect(timeOf(moment)).toBe(currentTime(gone));
  expect(moment.isLit).toBe(false);

  const world = createWorld(look, 1, { ...birth, age: moment.tick, isLit: moment.isLit });
  restoreSnapshot(world, moment);
  expect(takeSnapshot(world)).toEqual(moment);
  expect(world.emitter).toEqual(gone.emitter);
  const taken = { ...STILL, placesOrTakes: true };
  for (const each of [gone, world]) advance(each, taken, 0.1);
  expect(world.candle.isHeld).toBe(gone.candle.isHeld);
});

test("what a moment holds is its own", () => {
  const world = createWorld("paper", 1);
  const moment = takeSnapshot(world);
  const before = structuredClone(moment);
  advance(world, { ...STILL, forward: 1 }, 1);
  expect(moment).toEqual(before);
});
