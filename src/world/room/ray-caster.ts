import type { Vec3 } from "../geometry.js";
import { type Bvh, MAX_DEPTH } from "./bvh.js";

/**
 * Share by which triangles are enlarged for intersection, and boxes, in metres: rays must not pass between
 * neighbours whose vertices were rounded differently.
 */
const SEAM = 1e-5;

/**
 * Ray casting against triangles. The hit does not depend on the tree: of triangles equally far, it is the one that
 * was listed first.
 *
 * A hundred thousand rays are cast before a room's first frame, so their loop uses local variables only. Both
 * children of a node are tested together; the farther one is pushed with its distance, and skipped if a nearer hit
 * was found.
 */
export class RayCaster {
  /** Distance to the last hit, in lengths of the direction. */
  distance = Number.NaN;
  /** Its barycentric coordinates: weights of the triangle's second and third corner. */
  u = Number.NaN;
  v = Number.NaN;
  readonly #bvh: Bvh;
  readonly #triangles: Float32Array;
  readonly #numbers: Uint32Array;
  readonly #aside = new Uint32Array(MAX_DEPTH);
  readonly #ray = new Float64Array(7);
  readonly #distances = new Float64Array(MAX_DEPTH);

  /**
   * @param triangles nine coordinates each, as the tree's leaves count them
   * @param numbers of the triangles, as they were listed
   */
  constructor(bvh: Bvh, triangles: Float32Array, numbers: Uint32Array) {
    this.#bvh = bvh;
    this.#triangles = triangles;
    this.#numbers = numbers;
  }

  /**
   * Where the coordinates of the triangle begin that a ray meets first; -1 if it meets none.
   *
   * @param ignored by number, 1 for triangles that do not count
   */
  cast(
    origin: Readonly<Vec3>,
    direction: Readonly<Vec3>,
    farthest: number,
    ignored: Uint8Array | null = null,
  ): number {
    // Read from a Float64Array, so that V8 treats them as doubles: a quarter faster.
    const ray = this.#ray;
    for (let axis = 0; axis < 3; axis++) {
      ray[axis] = origin[axis]!;
      ray[axis + 3] = direction[axis]!;
    }
    ray[6] = farthest;
    const ox = ray[0]!;
    const oy = ray[1]!;
    const oz = ray[2]!;
    const dx = ray[3]!;
    const dy = ray[4]!;
    const dz = ray[5]!;
    const { boxes, link, count } = this.#bvh;
    if (link.length === 0) return -1;
    const aside = this.#aside;
    const distances = this.#distances;
    const t = this.#triangles;
    const numbers = this.#numbers;
    // Finite, since 0 times infinity is NaN for a ray in a face of a box.
    const ix = 1 / (dx || 1e-30);
    const iy = 1 / (dy || 1e-30);
    const iz = 1 / (dz || 1e-30);
    // Indices of the box's planes that the ray enters and leaves by.
    const inX = ix > 0 ? 0 : 3;
    const inY = iy > 0 ? 1 : 4;
    const inZ = iz > 0 ? 2 : 5;
    const outX = 3 - inX;
    const outY = 5 - inY;
    const outZ = 7 - inZ;
    // Boxes are larger by a seam: instead, the ray begins so much before them, and behind them.
    const inFromX = ox + (ix > 0 ? SEAM : -SEAM);
    const inFromY = oy + (iy > 0 ? SEAM : -SEAM);
    const inFromZ = oz + (iz > 0 ? SEAM : -SEAM);
    const outFromX = ox - (ix > 0 ? SEAM : -SEAM);
    const outFromY = oy - (iy > 0 ? SEAM : -SEAM);
    const outFromZ = oz - (iz > 0 ? SEAM : -SEAM);
    let nearest = ray[6]!;
    let found = -1;
    let [foundU, foundV] = [0, 0];
    let height = 0;
    for (let node = 0; ; ) {
      const items = count[node]!;
      if (items === 0) {
        const first = link[node]!;
        const second = first + 1;
        const a = first * 6;
        const b = a + 6;
        let to = 0;
        let enterA = 0;
        let leaveA = nearest;
        to = (boxes[a + inX]! - inFromX) * ix;
        if (to > enterA) enterA = to;
        to = (boxes[a + inY]! - inFromY) * iy;
        if (to > enterA) enterA = to;
        to = (boxes[a + inZ]! - inFromZ) * iz;
        if (to > enterA) enterA = to;
        to = (boxes[a + outX]! - outFromX) * ix;
        if (to < leaveA) leaveA = to;
        to = (boxes[a + outY]! - outFromY) * iy;
        if (to < leaveA) leaveA = to;
        to = (boxes[a + outZ]! - outFromZ) * iz;
        if (to < leaveA) leaveA = to;
        let enterB = 0;
        let leaveB = nearest;
        to = (boxes[b + inX]! - inFromX) * ix;
        if (to > enterB) enterB = to;
        to = (boxes[b + inY]! - inFromY) * iy;
        if (to > enterB) enterB = to;
        to = (boxes[b + inZ]! - inFromZ) * iz;
        if (to > enterB) enterB = to;
        to = (boxes[b + outX]! - outFromX) * ix;
        if (to < leaveB) leaveB = to;
        to = (boxes[b + outY]! - outFromY) * iy;
        if (to < leaveB) leaveB = to;
        to = (boxes[b + outZ]! - outFromZ) * iz;
        if (to < leaveB) leaveB = to;
        if (enterA <= leaveA) {
          node = first;
          if (enterB > leaveB) continue;
          if (enterA <= enterB) {
            aside[height] = second;
            distances[height++] = enterB;
          } else {
            aside[height] = first;
            distances[height++] = enterA;
            node = second;
          }
          continue;
        }
        if (enterB <= leaveB) {
          node = second;
          continue;
        }
      }
      // Möller and Trumbore 1997, "Fast, Minimum Storage Ray-Triangle Intersection".
      const begin = link[node]! * 9;
      for (let at = begin, end = begin + items * 9; at < end; at += 9) {
        const ax = t[at]!;
        const ay = t[at + 1]!;
        const az = t[at + 2]!;
        const ex = t[at + 3]! - ax;
        const ey = t[at + 4]! - ay;
        const ez = t[at + 5]! - az;
        const fx = t[at + 6]! - ax;
        const fy = t[at + 7]! - ay;
        const fz = t[at + 8]! - az;
        const px = dy * fz - dz * fy;
        const py = dz * fx - dx * fz;
        const pz = dx * fy - dy * fx;
        const determinant = ex * px + ey * py + ez * pz;
        const sx = ox - ax;
        const sy = oy - ay;
        const sz = oz - az;
        const u = (sx * px + sy * py + sz * pz) / determinant;
        if (!(u >= -SEAM && u <= 1 + SEAM)) continue;
        const qx = sy * ez - sz * ey;
        const qy = sz * ex - sx * ez;
        const qz = sx * ey - sy * ex;
        const v = (dx * qx + dy * qy + dz * qz) / determinant;
        if (!(v >= -SEAM && u + v <= 1 + SEAM)) continue;
        const distance = (fx * qx + fy * qy + fz * qz) / determinant;
        if (!(distance >= 0 && distance <= nearest)) continue;
        if (distance === nearest && found >= 0 && numbers[at / 9]! > numbers[found / 9]!) continue;
        if (ignored !== null && ignored[numbers[at / 9]!] === 1) continue;
        nearest = distance;
        found = at;
        foundU = u;
        foundV = v;
      }
      do {
        if (height === 0) {
          this.distance = nearest;
          this.u = foundU;
          this.v = foundV;
          return found;
        }
        height--;
      } while (distances[height]! > nearest);
      node = aside[height]!;
    }
  }
}
