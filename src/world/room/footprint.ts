import { length2 } from "../geometry.js";

/** A triangle cut by two planes has at most five corners. */
const CORNERS = 5;

/** Sweep of a circle over the floor, metres. An object, so that no number is boxed. */
export interface CircleSweep {
  x: number;
  z: number;
  dx: number;
  dz: number;
  radius: number;
  /** Fraction of the way that is free, as far as is known. */
  fraction: number;
}

/**
 * Footprint of a triangle: the plan of its part between two heights, a convex polygon, often a mere line.
 *
 * One object is reused for all triangles.
 */
export class Footprint {
  readonly x = new Float64Array(CORNERS);
  readonly z = new Float64Array(CORNERS);
  count = 0;
  /** The two heights, metres. */
  low = 0;
  high = 0;
  readonly #cut = new Float64Array(CORNERS * 3);

  /** Takes the nine coordinates from `at` on. False if nothing of the triangle is in between. */
  clip(triangles: Float32Array, at: number): boolean {
    const { low, high } = this;
    const cut = this.#cut;
    let cutCount = 0;
    // Sutherland and Hodgman 1974, "Reentrant polygon clipping", one plane after the other.
    for (let i = 0; i < 3; i++) {
      const a = at + i * 3;
      const b = at + ((i + 1) % 3) * 3;
      const ay = triangles[a + 1]!;
      const by = triangles[b + 1]!;
      if (ay >= low) {
        cut[cutCount * 3] = triangles[a]!;
        cut[cutCount * 3 + 1] = ay;
        cut[cutCount++ * 3 + 2] = triangles[a + 2]!;
      }
      if (ay < low !== by < low) {
        const t = (low - ay) / (by - ay);
        cut[cutCount * 3] = triangles[a]! + (triangles[b]! - triangles[a]!) * t;
        cut[cutCount * 3 + 1] = low;
        cut[cutCount++ * 3 + 2] = triangles[a + 2]! + (triangles[b + 2]! - triangles[a + 2]!) * t;
      }
    }
    this.count = 0;
    for (let i = 0; i < cutCount; i++) {
      const a = i * 3;
      const b = i + 1 === cutCount ? 0 : a + 3;
      const ay = cut[a + 1]!;
      const by = cut[b + 1]!;
      if (ay <= high) {
        this.x[this.count] = cut[a]!;
        this.z[this.count++] = cut[a + 2]!;
      }
      if (ay > high !== by > high) {
        const t = (high - ay) / (by - ay);
        this.x[this.count] = cut[a]! + (cut[b]! - cut[a]!) * t;
        this.z[this.count++] = cut[a + 2]! + (cut[b + 2]! - cut[a + 2]!) * t;
      }
    }
    return this.count > 0;
  }

  /** 0 inside. */
  distanceTo(x: number, z: number): number {
    let isLeft = false;
    let isRight = false;
    let nearest = Infinity;
    for (let i = 0; i < this.count; i++) {
      const ax = this.x[i]!;
      const az = this.z[i]!;
      const next = i + 1 === this.count ? 0 : i + 1;
      const ex = this.x[next]! - ax;
      const ez = this.z[next]! - az;
      const side = ex * (z - az) - ez * (x - ax);
      if (side > 0) isLeft = true;
      if (side < 0) isRight = true;
      const square = ex * ex + ez * ez;
      const t = square > 0 ? ((x - ax) * ex + (z - az) * ez) / square : 0;
      const s = Math.min(Math.max(t, 0), 1);
      const dx = ax + ex * s - x;
      const dz = az + ez * s - z;
      nearest = Math.min(nearest, dx * dx + dz * dz);
    }
    // There and back along a line, every point is on both sides.
    return isLeft !== isRight ? 0 : Math.sqrt(nearest);
  }

  /** Shortens the fraction of its way that a circle can go to where it touches. */
  sweep(way: CircleSweep): void {
    const { x, z, dx, dz, radius } = way;
    let { fraction } = way;
    if (this.distanceTo(x, z) < radius) {
      way.fraction = 0;
      return;
    }
    for (let i = 0; i < this.count; i++) {
      const ax = this.x[i]! - x;
      const az = this.z[i]! - z;
      fraction = Math.min(fraction, sweepPoint(ax, az, dx, dz, radius));
      const next = i + 1 === this.count ? 0 : i + 1;
      const ex = this.x[next]! - this.x[i]!;
      const ez = this.z[next]! - this.z[i]!;
      const length = length2(ex, ez);
      if (length === 0) continue;
      // Towards the edge's line, from the side that the circle is on.
      const distance = (ax * ez - az * ex) / length;
      const toward = Math.sign(distance);
      const speed = (toward * (dx * ez - dz * ex)) / length;
      if (speed <= 0) continue;
      const t = Math.max(0, (Math.abs(distance) - radius) / speed);
      const along = ((dx * t - ax) * ex + (dz * t - az) * ez) / (length * length);
      if (along >= 0 && along <= 1) fraction = Math.min(fraction, t);
    }
    way.fraction = fraction;
  }
}

/** Fraction of the way at which a circle from the origin touches a point that it does not cover yet. */
function sweepPoint(px: number, pz: number, dx: number, dz: number, radius: number): number {
  const a = dx * dx + dz * dz;
  const b = px * dx + pz * dz;
  const c = px * px + pz * pz - radius * radius;
  const discriminant = b * b - a * c;
  if (a === 0 || b <= 0 || discriminant < 0) return 1;
  return Math.max(0, (b - Math.sqrt(discriminant)) / a);
}
