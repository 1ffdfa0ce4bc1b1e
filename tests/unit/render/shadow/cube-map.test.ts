import { type mat4, vec4 } from "gl-matrix";
import { expect, test } from "vitest";
import { frustumTest } from "../../../../src/render/camera.ts";
import { clipFromShadowFace, FACES } from "../../../../src/render/shadow/cube-map.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";

const ORIGIN: Vec3 = [0.4, 1.1, -0.7];
const REACH = 1.125;
const NEAR = 0.04;

/** Clip position of a point, and its window position from -1 to 1. */
function projected(face: number, point: Vec3) {
  const clip = clipFromShadowFace(face, ORIGIN, REACH, NEAR) as unknown as mat4;
  const [x = 0, y = 0, z = 0, w = 0] = vec4.transformMat4(
    vec4.create(),
    [...point, 1] as never,
    clip,
  );
  return { w, x: x / w, y: y / w, depth: 0.5 + (0.5 * z) / w };
}

test("each face of the shadow cube looks along its axis, wider than the cube's own by its reach", () => {
  for (const [face, { axis, sign }] of FACES.entries()) {
    const ahead = ORIGIN.map((x, i) => (i === axis ? x + 2 * sign : x)) as Vec3;
    expect(projected(face, ahead).w).toBeCloseTo(2, 6);
    expect(projected(face, ahead).x).toBeCloseTo(0, 6);
    expect(projected(face, ahead).y).toBeCloseTo(0, 6);
    expect(projected(face ^ 1, ahead).w).toBeCloseTo(-2, 6);
    const across = ((face >> 1) + 1) % 3;
    const edge = ahead.map((x, axis) => (axis === across ? x + 2 : x)) as Vec3;
    expect(Math.abs(projected(face, edge).x)).toBeCloseTo(1 / REACH, 6);
    expect(projected(face, edge).y).toBeCloseTo(0, 6);
  }
});

test("depth in the shadow cube is 1 less 4 cm over the distance along the axis, so that it is linear across a plane", () => {
  const onWall = (y: number, z: number): Vec3 => [ORIGIN[0] + 2 + 0.5 * y - 0.3 * z, y, z];
  const [a, b, c] = [
    projected(0, onWall(1, -1)),
    projected(0, onWall(1.8, 0.4)),
    projected(0, onWall(0.2, -0.2)),
  ];
  expect(a.depth).toBeCloseTo(1 - 0.04 / a.w, 5);
  // Barycentric coordinates of a fourth point of the wall in the window.
  const d = projected(0, onWall(1.1, -0.4));
  const area = (p: typeof a, q: typeof a, r: typeof a) =>
    (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  const depth =
    (area(d, b, c) * a.depth + area(a, d, c) * b.depth + area(a, b, d) * c.depth) / area(a, b, c);
  expect(d.depth).toBeCloseTo(depth, 6);
});

test("a box beyond a face's edges is within its reach, as far as that goes", () => {
  const box = (across: number) => ({
    min: [ORIGIN[0] + 2, ORIGIN[1] + across, ORIGIN[2]] as Vec3,
    max: [ORIGIN[0] + 2, ORIGIN[1] + across + 0.1, ORIGIN[2]] as Vec3,
  });
  expect(frustumTest(clipFromShadowFace(0, ORIGIN, 1, 0.04))(box(1.9))).toBe(true);
  expect(frustumTest(clipFromShadowFace(0, ORIGIN, 1, 0.04))(box(2.1))).toBe(false);
  expect(frustumTest(clipFromShadowFace(0, ORIGIN, REACH, 0.04))(box(2.1))).toBe(true);
  expect(frustumTest(clipFromShadowFace(0, ORIGIN, REACH, 0.04))(box(2.3))).toBe(false);
});
