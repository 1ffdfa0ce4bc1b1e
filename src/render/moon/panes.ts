import type { Model, Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";

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

const dot = (a: ArrayLike<number>, b: ArrayLike<number>): number =>
  a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;

function corner({ positions, indices }: Part, index: number): Vec3 {
  const at = indices[index]! * 3;
  return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
}

function normalOf(part: Part, triangle: number): Vec3 {
  const [a, b, c] = [0, 1, 2].map((i) => corner(part, 3 * triangle + i)) as [Vec3, Vec3, Vec3];
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const normal: Vec3 = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal) || 1;
  return [normal[0] / length, normal[1] / length, normal[2] / length];
}

/** Smallest and largest of some numbers. */
class Range {
  min = Number.POSITIVE_INFINITY;
  max = Number.NEGATIVE_INFINITY;

  add(value: number): void {
    this.min = Math.min(this.min, value);
    this.max = Math.max(this.max, value);
  }

  has(value: number): boolean {
    return value >= this.min && value <= this.max;
  }
}

/** Part of the backdrop, as an upright rectangle, and the glass before it. */
class Backdrop {
  readonly normal: Vec3;
  readonly level: Vec3;
  readonly offset: number;
  readonly across = new Range();
  readonly up = new Range();
  readonly glass = { across: new Range(), up: new Range(), depths: [] as number[] };

  constructor(normal: Vec3, offset: number) {
    const length = Math.hypot(normal[0], normal[2]);
    this.normal = normal;
    this.level = [normal[2] / length, 0, -normal[0] / length];
    this.offset = offset;
  }

  extend(point: Vec3): void {
    this.across.add(dot(point, this.level));
    this.up.add(point[1]);
  }

  isBefore(point: Vec3): boolean {
    const depth = dot(point, this.normal) - this.offset;
    const isWithin = this.across.has(dot(point, this.level)) && this.up.has(point[1]);
    return isWithin && depth > 0 && depth < NEAR;
  }

  addGlass(point: Vec3): void {
    this.glass.across.add(dot(point, this.level));
    this.glass.up.add(point[1]);
    this.glass.depths.push(dot(point, this.normal) - this.offset);
  }

  get panes(): Panes | null {
    const { across, up, depths } = this.glass;
    if (depths.length === 0) return null;
    const depth = this.offset + depths.reduce((sum, one) => sum + one, 0) / depths.length;
    const { level, normal } = this;
    const width = across.max - across.min;
    return {
      corner: [
        level[0] * across.min + normal[0] * depth,
        up.min,
        level[2] * across.min + normal[2] * depth,
      ],
      across: [level[0] * width, 0, level[2] * width],
      up: [0, up.max - up.min, 0],
      normal,
    };
  }
}

export function areaOf({ across, up }: Panes): number {
  return Math.hypot(...across) * Math.hypot(...up);
}

/** The largest window of a room whose panes have the night behind them, as those of the built-in room; or null. */
export function panesOf({ parts }: Model): Panes | null {
  const backdrops: Backdrop[] = [];
  for (const part of parts.filter(({ material }) => material.name === NIGHT)) {
    for (let triangle = 0; 3 * triangle < part.indices.length; triangle++) {
      const normal = normalOf(part, triangle);
      if (Math.abs(normal[1]) > UPRIGHT) continue;
      const points = [0, 1, 2].map((i) => corner(part, 3 * triangle + i));
      const offset = dot(points[0]!, normal);
      let backdrop = backdrops.find(
        (one) => dot(one.normal, normal) > 0.999 && Math.abs(one.offset - offset) < 1e-3,
      );
      if (!backdrop) {
        backdrop = new Backdrop(normal, offset);
        backdrops.push(backdrop);
      }
      for (const point of points) backdrop.extend(point);
    }
  }
  for (const part of parts.filter(({ material }) => material.name === PANE)) {
    for (let triangle = 0; 3 * triangle < part.indices.length; triangle++) {
      const points = [0, 1, 2].map((i) => corner(part, 3 * triangle + i));
      const backdrop = backdrops.find((one) => points.every((point) => one.isBefore(point)));
      for (const point of points) backdrop?.addGlass(point);
    }
  }
  const windows = backdrops.flatMap(({ panes }) => panes ?? []);
  return windows.toSorted((a, b) => areaOf(b) - areaOf(a))[0] ?? null;
}

/** Whether a triangle blocks moonlight: panes and the backdrop behind them do not. */
export function stopsMoonlight(part: Part, triangle: number, panes: Panes | null): boolean {
  const { name, alphaMode } = part.material;
  if (alphaMode === "blend") return false;
  if (!panes || (name !== PANE && name !== NIGHT)) return true;
  const { corner: origin, normal } = panes;
  const depths = [0, 1, 2].map(
    (i) => dot(corner(part, 3 * triangle + i), normal) - dot(origin, normal),
  );
  // With a tolerance, since glass is not flat.
  return depths.some((depth) => Math.abs(depth) > NEAR);
}
