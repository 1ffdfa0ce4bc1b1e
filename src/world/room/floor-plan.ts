import { inset, length2, type Vec3 } from "../geometry.js";
import { WALKER_RADIUS } from "../player/player.js";
import type { CollisionMesh } from "./collision-mesh.js";
import { type FloorGrid, middleOf } from "./floor-grid.js";
import { floorLevel } from "./floor-level.js";
import { type FloorSurvey, HEADROOM, surveyFloor } from "./floor-survey.js";

/** Longest stretch walked at once, metres. */
const STRETCH = WALKER_RADIUS / 4;
/** Iterations of the push out of an obstacle. */
const PUSHES = 8;
/** Two points of a corner within this are the same, metres. */
const NEGLIGIBLE = 1e-5;
/** Margin for walking around a model that is too small to stand in, metres. */
const EXHIBIT_MARGIN = 2.5;
const EXHIBIT_DISTANCE = 1.2;

/**
 * Floor plan: the walkable area of a room, and collision against it, with sliding.
 *
 * A grid marks the squares that anything touches between ankle and head; its exact distance field gives the
 * clearance. Reduced by half a square's diagonal and by the error of interpolation, it is a lower bound, so a
 * walker never overlaps a triangle.
 */
export class FloorPlan {
  readonly floor: number;
  /** Whether there is anything to stand on. Rooms without a floor are walked in all the same. */
  readonly hasFloor: boolean;
  /** Whether one can stand in the model, or else only beside it. */
  readonly isInside: boolean;
  /** Start of the visitor: on the floor, free. Metres. */
  readonly start: Readonly<Vec3>;
  readonly #grid: FloorGrid;
  readonly #clearance: FloorSurvey["clearance"];
  readonly #isReachable: FloorSurvey["isReachable"];
  /** Round, metres. */
  #obstacle: { readonly x: number; readonly z: number; readonly radius: number } | null = null;
  /** Of the last point sampled: clearance, metres, and its gradient. */
  readonly #sampled = { clearance: Number.NaN, x: Number.NaN, z: Number.NaN };
  /** A point that is asked for, the next stretch of a walk, and where it leads. Metres. */
  readonly #spot = { x: Number.NaN, z: Number.NaN };
  readonly #stretch = { x: Number.NaN, z: Number.NaN };
  readonly #destination = { x: Number.NaN, z: Number.NaN };
  #isTouching = false;

  /** @param spawn where to start if it is free, or else near; at the floor's height or above it */
  constructor(collision: CollisionMesh, spawn: Readonly<Vec3> | null = null) {
    const from = spawn?.every(Number.isFinite) ? spawn : null;
    this.floor = floorLevel(collision, from);
    const { bounds } = collision;
    const [x, z] = [(bounds.min[0] + bounds.max[0]) / 2, (bounds.min[2] + bounds.max[2]) / 2];
    let target: readonly [number, number] = from ? [from[0], from[2]] : [x, z];
    let survey = surveyFloor(collision, bounds, this.floor, target, from !== null);
    // Too small to stand in: one walks around it.
    this.isInside = survey !== null;
    if (!survey) {
      target = from ? target : [x, bounds.max[2] + EXHIBIT_DISTANCE];
      // Only x and z of it are read.
      const around = inset(bounds, -EXHIBIT_MARGIN);
      survey = surveyFloor(collision, around, this.floor, target, true);
    }
    if (!survey) throw new RangeError("There is nowhere to stand in or around the room.");
    this.#grid = survey.grid;
    this.#clearance = survey.clearance;
    this.#isReachable = survey.isReachable;
    this.hasFloor = survey.hasFloor;
    const start: Vec3 = [target[0], this.floor, target[1]];
    if (from || !this.isInside) this.settle(start);
    else [start[0], start[2]] = middleOf(survey.grid, survey.start);
    this.start = start;
  }

  /** Adds a round obstacle, metres, or removes it; above the head there is none. */
  setObstacle(foot: Readonly<Vec3> | null, radius = 0): void {
    const isInTheWay = foot !== null && foot[1] < this.floor + HEADROOM;
    this.#obstacle = isInTheWay ? { x: foot[0], z: foot[2], radius } : null;
  }

  /** Lower bound of the distance to the nearest obstacle, metres. 0 or less outside the room. */
  clearance(x: number, z: number): number {
    this.#spot.x = x;
    this.#spot.z = z;
    this.#sample(this.#spot);
    return this.#sampled.clearance;
  }

  /** Whether a walker fits there, and can reach it from the start. */
  isFree(x: number, z: number): boolean {
    this.#spot.x = x;
    this.#spot.z = z;
    return this.#isSpotFree();
  }

  #isSpotFree(): boolean {
    this.#sample(this.#spot);
    return this.#sampled.clearance >= WALKER_RADIUS && this.#isReachableNear(this.#spot);
  }

  /**
   * Moves straight as far as the way is free, and slides along obstacles.
   *
   * The part of `velocity` that led into something is lost.
   */
  walk(position: Vec3, way: Readonly<Vec3>, velocity?: Vec3): void {
    const dx = way[0];
    const dz = way[2];
    const length = Math.sqrt(dx * dx + dz * dz);
    if (!(length > 0 && length < Infinity)) return;
    const { cell, columns, rows } = this.#grid;
    const reach = Math.min(length, (columns + rows) * cell);
    const stretches = Math.ceil(reach / STRETCH);
    this.#stretch.x = (dx / length) * (reach / stretches);
    this.#stretch.z = (dz / length) * (reach / stretches);
    const destination = this.#destination;
    let isBlocked = false;
    for (let i = 0; i < stretches; i++) {
      this.#isTouching = false;
      isBlocked = !this.#slide(position);
      if (isBlocked) break;
      const moved = Math.abs(destination.x - position[0]) + Math.abs(destination.z - position[2]);
      position[0] = destination.x;
      position[2] = destination.z;
      // The next stretch is the same, and would end here too.
      if (moved < NEGLIGIBLE * 0.1) break;
    }
    if (isBlocked) this.settle(position);
    if (!velocity) return;
    if (isBlocked) velocity[0] = velocity[2] = 0;
    else if (this.#isTouching) this.#deflect(velocity);
  }

  /** Moves a position to the nearest free spot. Does nothing to one that is free. */
  settle(position: Vec3): void {
    this.#spot.x = position[0];
    this.#spot.z = position[2];
    if (this.#isSpotFree()) return;
    const x = position[0];
    const z = position[2];
    const nearest = this.#nearestSquare(x, z);
    if (nearest < 0) return;
    const [freeX, freeZ] = middleOf(this.#grid, nearest);
    let free = 0;
    let blocked = Number.isFinite(x) && Number.isFinite(z) ? 1 : 0;
    for (let i = 0; i < 24 && blocked > 0; i++) {
      const middle = (free + blocked) / 2;
      if (this.isFree(freeX + (x - freeX) * middle, freeZ + (z - freeZ) * middle)) free = middle;
      else blocked = middle;
    }
    position[0] = blocked > 0 ? freeX + (x - freeX) * free : freeX;
    position[2] = blocked > 0 ? freeZ + (z - freeZ) * free : freeZ;
  }

  /** Moves by one stretch, pushed out of obstacles. False if there is no way. */
  #slide(from: Readonly<Vec3>): boolean {
    const x = from[0];
    const z = from[2];
    const dx = this.#stretch.x;
    const dz = this.#stretch.z;
    const destination = this.#destination;
    const sample = this.#sampled;
    destination.x = x + dx;
    destination.z = z + dz;
    for (let pushes = 0; pushes <= PUSHES; pushes++) {
      this.#sample(destination);
      const lack = WALKER_RADIUS - sample.clearance;
      const distance = length2(destination.x - x, destination.z - z);
      if (lack <= 0) {
        if (distance <= 2 * STRETCH && this.#isReachableNear(destination)) return true;
        break;
      }
      this.#isTouching = true;
      const steepness = length2(sample.x, sample.z);
      if (steepness < 1e-3) break;
      const push = Math.min((lack + NEGLIGIBLE) / steepness, STRETCH) / steepness;
      destination.x += sample.x * push;
      destination.z += sample.z * push;
    }
    // In a notch the pushes alternate: then along an axis, or not at all.
    return this.#go(x + dx, z) || this.#go(x, z + dz);
  }

  #go(x: number, z: number): boolean {
    if (!this.isFree(x, z)) return false;
    this.#destination.x = x;
    this.#destination.z = z;
    return true;
  }

  /** Removes the part of a velocity that leads into the obstacle that is touched. */
  #deflect(velocity: Vec3): void {
    this.#sample(this.#destination);
    const sample = this.#sampled;
    const steepness = length2(sample.x, sample.z);
    if (steepness < 1e-3) return;
    const nx = sample.x / steepness;
    const nz = sample.z / steepness;
    const into = Math.min(0, velocity[0] * nx + velocity[2] * nz);
    velocity[0] -= into * nx;
    velocity[2] -= into * nz;
  }

  /** Finds the interpolated clearance at a point, and its gradient. */
  #sample({ x, z }: Readonly<{ x: number; z: number }>): void {
    const { cell, columns, rows } = this.#grid;
    const u = (x - this.#grid.x) / cell - 0.5;
    const v = (z - this.#grid.z) / cell - 0.5;
    const column = Math.floor(u);
    const row = Math.floor(v);
    const sample = this.#sampled;
    const field = this.#clearance;
    sample.x = sample.z = 0;
    sample.clearance = -cell;
    if (!(column >= 0 && row >= 0 && column < columns - 1 && row < rows - 1)) return;
    const at = row * columns + column;
    const s = u - column;
    const t = v - row;
    const a = field[at]!;
    const b = field[at + 1]!;
    const c = field[at + columns]!;
    const d = field[at + columns + 1]!;
    sample.x = ((b - a) * (1 - t) + (d - c) * t) / cell;
    sample.z = ((c - a) * (1 - s) + (d - b) * s) / cell;
    sample.clearance = (a * (1 - s) + b * s) * (1 - t) + (c * (1 - s) + d * s) * t;
    if (!this.#obstacle) return;
    const { x: standingX, z: standingZ, radius } = this.#obstacle;
    const distance = length2(x - standingX, z - standingZ);
    if (distance - radius >= sample.clearance) return;
    sample.x = distance > 0 ? (x - standingX) / distance : 1;
    sample.z = distance > 0 ? (z - standingZ) / distance : 0;
    sample.clearance = distance - radius;
  }

  /** Whether the roomiest of the four squares around a point can be walked to. */
  #isReachableNear({ x, z }: Readonly<{ x: number; z: number }>): boolean {
    const { cell, columns } = this.#grid;
    const column = Math.floor((x - this.#grid.x) / cell - 0.5);
    const row = Math.floor((z - this.#grid.z) / cell - 0.5);
    let at = row * columns + column;
    const field = this.#clearance;
    const beside = field[at + 1]! > field[at]! ? at + 1 : at;
    const below = field[at + columns + 1]! > field[at + columns]! ? at + columns + 1 : at + columns;
    at = field[below]! > field[beside]! ? below : beside;
    return this.#isReachable[at] === 1;
  }

  /** The reachable square nearest to a point, clear of the obstacle; -1 if there is none. */
  #nearestSquare(x: number, z: number): number {
    const { cell, columns, rows } = this.#grid;
    const toX = Number.isFinite(x) ? x : this.start[0];
    const toZ = Number.isFinite(z) ? z : this.start[2];
    let nearest = -1;
    let least = Infinity;
    for (let at = 0, row = 0; row < rows; row++) {
      const dz = this.#grid.z + (row + 0.5) * cell - toZ;
      for (let column = 0; column < columns; column++, at++) {
        if (this.#isReachable[at] === 0) continue;
        const dx = this.#grid.x + (column + 0.5) * cell - toX;
        const square = dx * dx + dz * dz;
        if (square >= least || this.#isUnderObstacle(toX + dx, toZ + dz)) continue;
        least = square;
        nearest = at;
      }
    }
    return nearest;
  }

  #isUnderObstacle(x: number, z: number): boolean {
    if (!this.#obstacle) return false;
    const { x: standingX, z: standingZ, radius } = this.#obstacle;
    return length2(x - standingX, z - standingZ) < radius + WALKER_RADIUS + NEGLIGIBLE;
  }
}
