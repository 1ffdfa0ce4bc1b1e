import { vec3 } from "gl-matrix";
import type { Model, Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";
import { isMostlyClear } from "../mesh/mesh.js";
import { crossOf, verticesOf } from "../mesh/triangles.js";
import { rangeAlong } from "../points.js";

/** Materials of the built-in room: panes, and the night behind its openings. */
const PANE = "pane";
const NIGHT = "night";
/** Largest distance of panes from the backdrop, metres. */
const NEAR = 0.12;
/** Vertical share of the normal from which a backdrop lies under the floor or over the ceiling. */
const UPRIGHT = 0.5;

/** Panes of a window, as a rectangle, through which the night is seen. Metres. */
export interface Panes {
  readonly corner: Vec3;
  /** Edges: level, and upwards. */
  readonly across: Vec3;
  readonly up: Vec3;
  /** Into the room, of length 1. */
  readonly normal: Vec3;
}

/** A part of the backdrop, as an upright rectangle, and the glass before it. */
interface Backdrop {
  readonly normal: Vec3;
  readonly level: Vec3;
  readonly offset: number;
  readonly points: Vec3[];
  readonly glass: Vec3[];
}

const UP: Vec3 = [0, 1, 0];

const isWithin = ([least, most]: readonly [number, number], axis: Vec3, point: Vec3) =>
  vec3.dot(axis, point) >= least && vec3.dot(axis, point) <= most;

function* trianglesOf({ parts }: Model, name: string): Generator<[Vec3, Vec3, Vec3]> {
  for (const part of parts.filter(({ material }) => material.name === name)) {
    for (let triangle = 0; 3 * triangle < part.indices.length; triangle++) {
      yield verticesOf(part, triangle);
    }
  }
}

function backdropsOf(model: Model): Backdrop[] {
  const backdrops: Backdrop[] = [];
  for (const corners of trianglesOf(model, NIGHT)) {
    const cross = crossOf(corners);
    const length = Math.hypot(...cross) || 1;
    const normal = cross.map((x) => x / length) as Vec3;
    if (Math.abs(normal[1]) > UPRIGHT) continue;
    const offset = vec3.dot(corners[0], normal);
    const known = backdrops.find(
      (one) => vec3.dot(one.normal, normal) > 0.999 && Math.abs(one.offset - offset) < 1e-3,
    );
    if (known) known.points.push(...corners);
    else {
      const wide = Math.hypot(normal[0], normal[2]);
      const level: Vec3 = [normal[2] / wide, 0, -normal[0] / wide];
      backdrops.push({ normal, level, offset, points: [...corners], glass: [] });
    }
  }
  return backdrops;
}

function windowOf({ normal, level, offset, glass }: Backdrop): Panes | null {
  if (glass.length === 0) return null;
  const depths = glass.map((point) => vec3.dot(point, normal) - offset);
  const depth = offset + depths.reduce((sum, one) => sum + one, 0) / depths.length;
  const [left, right] = rangeAlong(level, glass);
  const [bottom, top] = rangeAlong(UP, glass);
  return {
    corner: [level[0] * left + normal[0] * depth, bottom, level[2] * left + normal[2] * depth],
    across: [level[0] * (right - left), 0, level[2] * (right - left)],
    up: [0, top - bottom, 0],
    normal,
  };
}

export function areaOf({ across, up }: Panes): number {
  return Math.hypot(...across) * Math.hypot(...up);
}

/** The largest window of a room whose panes have the night behind them, as those of the built-in room; or null. */
export function panesOf(model: Model): Panes | null {
  const backdrops = backdropsOf(model).map((backdrop) => {
    const { normal, level, offset, points } = backdrop;
    const [across, up] = [rangeAlong(level, points), rangeAlong(UP, points)];
    const isBefore = (point: Vec3) => {
      const depth = vec3.dot(point, normal) - offset;
      const isNear = depth > 0 && depth < NEAR;
      return isNear && isWithin(across, level, point) && isWithin(up, UP, point);
    };
    return { ...backdrop, isBefore };
  });
  for (const corners of trianglesOf(model, PANE)) {
    backdrops.find(({ isBefore }) => corners.every(isBefore))?.glass.push(...corners);
  }
  const windows = backdrops.flatMap((backdrop) => windowOf(backdrop) ?? []);
  return windows.toSorted((a, b) => areaOf(b) - areaOf(a))[0] ?? null;
}

/** Whether a triangle blocks moonlight: panes, the backdrop behind them and what is mostly clear do not. */
export function stopsMoonlight(part: Part, triangle: number, panes: Panes | null): boolean {
  const { name } = part.material;
  if (isMostlyClear(part)) return false;
  if (!panes || (name !== PANE && name !== NIGHT)) return true;
  const { corner: origin, normal } = panes;
  const depths = verticesOf(part, triangle).map(
    (point) => vec3.dot(point, normal) - vec3.dot(origin, normal),
  );
  // With a tolerance, since glass is not flat.
  return depths.some((depth) => Math.abs(depth) > NEAR);
}
