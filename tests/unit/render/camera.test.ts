import { type mat4, vec4 } from "gl-matrix";
import { describe, expect, test } from "vitest";
import {
  clipFromWorld,
  FIELD_OF_VIEW,
  frustumTest,
  projectionScale,
  shadowFrustumTest,
} from "../../../src/render/camera.ts";
import { frameBlock } from "../../../src/render/frame-block.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.ts";
import { reprojectionMatrix, screenMotion } from "../../../src/render/gbuffer/reprojection.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { type Player, walk } from "../../../src/world/player/player.ts";
import { UNBOUNDED } from "../../../src/world/room/movement-bounds.ts";
import { createWorld } from "../../support/world.ts";

const EYE: Vec3 = [1, 1.6, -2];

/** Where a point of the room lands in the picture, -1 to 1, and how far ahead it is. */
function project(matrix: mat4, [x, y, z]: Vec3) {
  const clip = vec4.transformMat4(vec4.create(), [x, y, z, 1], matrix) as number[];
  return { x: clip[0]! / clip[3]!, y: clip[1]! / clip[3]!, ahead: clip[3]! };
}

describe("the camera", () => {
  test.each([0, 0.9, Math.PI / 2, -2.4, Math.PI])(
    "looks where the visitor walks, at yaw %d",
    (yaw) => {
      const player: Player = { position: [...EYE], velocity: [0, 0, 0], yaw, pitch: 0 };
      walk(player, { ...STILL, forward: 1 }, { walk: 2, run: 4 }, UNBOUNDED, 3);
      const { x, y, ahead } = project(clipFromWorld(EYE, yaw, 0, 16 / 9), player.position);
      expect(x).toBeCloseTo(0, 5);
      expect(y).toBeCloseTo(0, 5);
      expect(ahead).toBeGreaterThan(5);
    },
  );

  test("has what is right on the right and what is above above", () => {
    const { x, y } = project(clipFromWorld(EYE, 0, 0, 1), [1.2, 1.9, -4]);
    expect(x).toBeGreaterThan(0);
    expect(y).toBeGreaterThan(0);
  });

  test("looks up for positive pitch, left for positive yaw", () => {
    const ahead: Vec3 = [1, 1.6, -4];
    expect(project(clipFromWorld(EYE, 0, 0.2, 1), ahead).y).toBeLessThan(-0.1);
    expect(project(clipFromWorld(EYE, 0.2, 0, 1), ahead).x).toBeGreaterThan(0.1);
  });

  test("sees the paper's 45 degrees across the picture's shorter side", () => {
    expect(FIELD_OF_VIEW).toBe(Math.PI / 4);
    const reach = 2 * Math.tan(FIELD_OF_VIEW / 2);
    const top: Vec3 = [1, 1.6 + reach, -4];
    const right: Vec3 = [1 + reach, 1.6, -4];
    for (const aspect of [1, 16 / 9]) {
      expect(project(clipFromWorld(EYE, 0, 0, aspect), top).y).toBeCloseTo(1, 5);
    }
    for (const aspect of [0.46, 0.7, 1]) {
      expect(project(clipFromWorld(EYE, 0, 0, aspect), right).x).toBeCloseTo(1, 5);
    }
  });

  test("knows how many pixels a metre takes", () => {
    const above: Vec3 = [1, 2.6, -7];
    const { y } = project(clipFromWorld(EYE, 0, 0, 1), above);
    expect((y / 2) * 720).toBeCloseTo(projectionScale(720) / 5, 2);
    const settings = { features: { normalMaps: true } } as FrameSettings;
    const size = { width: 1280, height: 720 };
    const frame = frameBlock(createWorld("physical", 1), settings, size, 1);
    const [, a = 0, , , , b = 0, , , , c = 0] = frame.clipFromWorld;
    expect(frame.projectionScale).toBeCloseTo(360 * Math.hypot(a, b, c), 2);
  });
});

test("What shows a corner in the picture is in sight; what lies all beyond an edge, or behind, is not", () => {
  const clip = clipFromWorld(EYE, 0.7, -0.2, 16 / 9);
  const isSeen = frustumTest(clip);
  let seen = 0;
  for (let i = 0; i < 4000; i++) {
    const at = (axis: number) => EYE[axis]! + ((i * [17, 29, 43][axis]!) % 101) / 10 - 5;
    const min: Vec3 = [at(0), at(1), at(2)];
    const max: Vec3 = [min[0] + 0.4, min[1] + 0.2, min[2] + 0.6];
    const corners = Array.from({ length: 8 }, (_, corner) =>
      project(clip, [0, 1, 2].map((axis) => ((corner >> axis) & 1 ? max : min)[axis]!) as Vec3),
    );
    const shows = corners.some(({ x, y, ahead }) => ahead > 0.05 && Math.max(x, -x, y, -y) < 1);
    if (shows) expect(isSeen({ min, max })).toBe(true);
    if (corners.every(({ ahead }) => ahead < 0)) expect(isSeen({ min, max })).toBe(false);
    seen += isSeen({ min, max }) ? 1 : 0;
  }
  // A picture of 45 by 73 degrees shows a tenth of all around.
  expect(seen / 4000).toBeGreaterThan(0.03);
  expect(seen / 4000).toBeLessThan(0.3);
});

test("What stands between the flame and what shows is before it, wherever the flame is", () => {
  const clip = clipFromWorld(EYE, 0.7, -0.2, 16 / 9);
  const isSeen = frustumTest(clip);
  const box = (at: Vec3) => ({ min: at, max: at });
  let kept = 0;
  let count = 0;
  for (let i = 0; i < 3000; i++) {
    const at = (axis: number, salt: number) =>
      EYE[axis]! + ((i * [17, 29, 43][axis]! + salt) % 101) / 10 - 5;
    const light: Vec3 = [at(0, 31), at(1, 57), at(2, 83)];
    const isBefore = shadowFrustumTest(clip, light, 0);
    const shown: Vec3 = [at(0, 0), at(1, 0), at(2, 0)];
    if (isSeen(box(shown))) {
      const between = shown.map((x, axis) => x + ((i % 9) / 8) * (light[axis]! - x)) as Vec3;
      expect(isBefore(box(between))).toBe(true);
    }
    if (!isSeen(box(light))) continue;
    count++;
    if (isBefore(box(shown))) kept++;
  }
  // Of a flame in sight, what is out of sight is left out.
  expect(count).toBeGreaterThan(100);
  expect(kept / count).toBeLessThan(0.3);
});

test("what is in one picture is found in another, and a picture that turns shifts by as much", () => {
  const then = clipFromWorld([0.1, 1.6, 2], 0.3, -0.1, 1.5);
  const now = clipFromWorld([0.15, 1.58, 1.95], 0.33, -0.12, 1.5);
  const between = reprojectionMatrix(now, then);
  const placeIn = (clip: typeof now, [x, y, z]: readonly [number, number, number]) => {
    const at = (row: number) =>
      clip[row]! * x + clip[row + 4]! * y + clip[row + 8]! * z + clip[row + 12]!;
    return [0, 1, 2].map((row) => 0.5 + (0.5 * at(row)) / at(3));
  };
  for (const thing of [
    [-0.4, 1.2, 0.3],
    [-1.5, 2.1, -2],
  ] as const) {
    const [u = 0, v = 0, depth = 0] = placeIn(now, thing);
    const at = (row: number) =>
      between[row]! * u + between[row + 4]! * v + between[row + 8]! * depth + between[row + 12]!;
    for (const [row, expected] of placeIn(then, thing).entries()) {
      expect(at(row) / at(3)).toBeCloseTo(expected, 4);
    }
  }
  expect(screenMotion(reprojectionMatrix(now, now), 2)).toBeCloseTo(0, 4);
  const turned = (angle: number) =>
    screenMotion(
      reprojectionMatrix(clipFromWorld([0, 1, 0], angle, 0, 1), clipFromWorld([0, 1, 0], 0, 0, 1)),
      2,
    );
  // At the picture's edge, 22.5 degrees aside.
  const edge = Math.PI / 8;
  const moved = Math.tan(edge + 0.02) - Math.tan(edge);
  expect(turned(0.02)).toBeCloseTo(moved / (2 * Math.tan(edge)), 3);
  expect(turned(2)).toBe(Number.POSITIVE_INFINITY);
});
