import { expect, test } from "vitest";
import { type Bounds, clampInside, inset, type Vec3 } from "../../../src/world/geometry.ts";

const BOX: Bounds = { min: [-5, 0, -4], max: [5, 3, 2] };

test("an inset box is nearer to the middle by the margin at every face", () => {
  expect(inset(BOX, 0.5)).toEqual({ min: [-4.5, 0.5, -3.5], max: [4.5, 2.5, 1.5] });
});

test("a point inside stays where it is, and keeps its velocity", () => {
  const position: Vec3 = [1, 2, -3];
  const velocity: Vec3 = [4, 5, 6];
  clampInside(position, BOX, velocity);
  expect(position).toEqual([1, 2, -3]);
  expect(velocity).toEqual([4, 5, 6]);
});

test("a point outside moves to the nearest one inside, and loses the velocity that led out", () => {
  const position: Vec3 = [7, 2, -9];
  const velocity: Vec3 = [4, 5, -6];
  clampInside(position, BOX, velocity);
  expect(position).toEqual([5, 2, -4]);
  expect(velocity).toEqual([0, 5, 0]);
});

test("a point on a wall may slide along it", () => {
  const velocity: Vec3 = [0, 0, 2];
  clampInside([5, 2, 0], BOX, velocity);
  expect(velocity).toEqual([0, 0, 2]);
});

test("a place that is no number, or infinitely far, becomes one inside", () => {
  const position: Vec3 = [Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  clampInside(position, BOX);
  expect(position).toEqual([0, 3, -4]);
});
