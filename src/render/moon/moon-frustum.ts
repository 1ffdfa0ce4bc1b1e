import { vec3 } from "gl-matrix";
import type { Model, Part } from "../../assets/model.js";
import { moonLuma } from "../../light/moonlight.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { verticesOf } from "../mesh/triangles.js";
import { pointOn, rangeAlong } from "../points.js";
import { areaOf, type Panes, stopsMoonlight } from "./panes.js";

/** Luminance of the sky under a moon of 1 lx, cd/m²: 0.002 under one of 0.15 lx. */
export const SKY = 0.002 / 0.15;
/** Around what the map has to hold, metres. */
const MARGIN = 0.03;

/** Parallel light of the moon through a window, or onto a whole room: the box that its map covers. */
export interface MoonFrustum {
  /** Corner of the map, before the room, metres. */
  readonly corner: Vec3;
  /** Edges of the map, perpendicular to the light, metres. */
  readonly across: Vec3;
  readonly up: Vec3;
  /** In which the light goes, of length 1. */
  readonly direction: Vec3;
  readonly depth: number;
  readonly panes: Panes | null;
}

const scale = (v: Readonly<Vec3>, by: number): Vec3 => [v[0] * by, v[1] * by, v[2] * by];

function cornersOf({ min, max }: Bounds): Vec3[] {
  return Array.from({ length: 8 }, (_, i) => [
    (i & 1 ? max : min)[0],
    (i & 2 ? max : min)[1],
    (i & 4 ? max : min)[2],
  ]);
}

export function moonFrustum(
  direction: Vec3,
  { min, max }: Model["bounds"],
  panes: Panes | null,
): MoonFrustum {
  const isSteep = Math.hypot(direction[0], direction[2]) < 1e-4;
  const [dx, dz] = isSteep ? [0, 1] : [direction[0], direction[2]];
  const level = Math.hypot(dx, dz);
  const across: Vec3 = [-dz / level, 0, dx / level];
  const up = vec3.cross([0, 0, 0], across, direction) as Vec3;
  const room = cornersOf({ min: [...min], max: [...max] });
  const lit = panes
    ? [0, 1, 2, 3].map((i) => pointOn(panes.corner, panes.across, panes.up, i & 1, i >> 1))
    : room;
  const [left, right] = rangeAlong(across, lit);
  const [bottom, top] = rangeAlong(up, lit);
  const [near, far] = rangeAlong(direction, room);
  return {
    corner: pointOn(scale(direction, near - MARGIN), across, up, left - MARGIN, bottom - MARGIN),
    across: scale(across, right - left + 2 * MARGIN),
    up: scale(up, top - bottom + 2 * MARGIN),
    direction,
    depth: far - near + 2 * MARGIN,
    panes,
  };
}

/** Clip space of the map, from world space. */
export function clipFromFrustum({ corner, across, up, direction, depth }: MoonFrustum) {
  const rows: readonly (readonly [axis: Vec3, scale: number])[] = [
    [across, 2 / vec3.dot(across, across)],
    [up, 2 / vec3.dot(up, up)],
    [direction, 2 / depth],
  ];
  const out = new Float32Array(16);
  for (const [row, [axis, factor]] of rows.entries()) {
    for (let column = 0; column < 3; column++) out[column * 4 + row] = axis[column]! * factor;
    out[12 + row] = -vec3.dot(axis, corner) * factor - 1;
  }
  out[15] = 1;
  return out;
}

/** Members of the shaders' `Moon` block. `columns`, `rows`, `paneRows`: of surfels on the map, and on the panes. */
export function moonBlock(
  { corner, across, up, direction, depth, panes }: MoonFrustum,
  { columns, rows, paneRows }: Readonly<Record<"columns" | "rows" | "paneRows", number>>,
) {
  const nowhere: Vec3 = [0, 0, 0];
  return {
    position: corner,
    depth,
    across,
    up,
    direction,
    sky: SKY,
    surfelArea: (Math.hypot(...across) * Math.hypot(...up)) / (columns * rows),
    surfelColumns: columns,
    paneRows,
    paneArea: panes ? areaOf(panes) : 0,
    paneCorner: panes?.corner ?? nowhere,
    paneAcross: panes?.across ?? nowhere,
    paneUp: panes?.up ?? nowhere,
    paneNormal: panes?.normal ?? nowhere,
    luma: moonLuma(),
  };
}

/** The parts of a room that the map can show, of the triangles that stop the light. */
export function moonCasters(parts: readonly Part[], frustum: MoonFrustum): Part[] {
  const { corner, across, up, panes } = frustum;
  const isOnMap = (part: Part, triangle: number) =>
    [across, up].every((edge) => {
      const places = verticesOf(part, triangle).map(
        (point) => vec3.dot(vec3.subtract(point, point, corner), edge) / vec3.dot(edge, edge),
      );
      return Math.max(...places) >= 0 && Math.min(...places) <= 1;
    });
  return parts.map((part) => {
    const indices: number[] = [];
    for (let triangle = 0; 3 * triangle < part.indices.length; triangle++) {
      if (!isOnMap(part, triangle) || !stopsMoonlight(part, triangle, panes)) continue;
      indices.push(...part.indices.subarray(3 * triangle, 3 * triangle + 3));
    }
    return { ...part, indices: Uint32Array.from(indices) };
  });
}
