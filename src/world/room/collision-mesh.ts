import type { Bounds, Vec3 } from "../geometry.js";
import { type Bvh, buildBvh, MAX_DEPTH } from "./bvh.js";
import { type CircleSweep, Footprint } from "./footprint.js";
import { RayCaster } from "./ray-caster.js";

/** Metres, +Y up. */
export interface Triangles {
  /** xyz */
  readonly positions: Float32Array;
  readonly indices: Uint16Array | Uint32Array;
}

export interface RayHit {
  distance: number;
  /** Number of the triangle, as the parts list them, one part after the other. */
  triangle: number;
  isBack: boolean;
  /** Barycentric coordinates: weights of the triangle's second and third corner. */
  u: number;
  v: number;
  /** Unit, on the side that the ray came from. */
  readonly normal: Vec3;
}

const NO_WAY: Readonly<Vec3> = [0, 0, 0];
/** Triangles kept of a larger room, the largest first: about 120 MB. */
const MAX_TRIANGLES = 2_000_000;

/**
 * Collision mesh of a room: triangles without order or orientation, in a bounding volume hierarchy.
 *
 * Queries allocate nothing. Triangles that are not finite are left out.
 */
export class CollisionMesh {
  /** Nine coordinates each. */
  readonly triangles: Float32Array;
  readonly bounds: Bounds;
  readonly #bvh: Bvh;
  /** Original number of each triangle. */
  readonly #numbers: Uint32Array;
  readonly #stack = new Uint32Array(MAX_DEPTH);
  readonly #leaves: Uint32Array;
  readonly #footprint = new Footprint();
  readonly #rays: RayCaster;
  readonly #between: Vec3 = [0, 0, 0];
  readonly #way: CircleSweep = { x: 0, z: 0, dx: 0, dz: 0, radius: 0, fraction: 1 };
  readonly #hit: RayHit = {
    distance: 0,
    triangle: 0,
    isBack: false,
    u: 0,
    v: 0,
    normal: [0, 0, 0],
  };

  constructor(parts: readonly Triangles[], maxTriangles = MAX_TRIANGLES) {
    const { soup, numbers } = largest(gather(parts), maxTriangles);
    const count = soup.length / 9;
    const boxes = new Float32Array(count * 6);
    for (let from = 0, to = 0; from < soup.length; from += 6, to += 3) {
      for (let end = from + 3; from < end; from++, to++) {
        boxes[to] = Math.min(soup[from]!, soup[from + 3]!, soup[from + 6]!);
        boxes[to + 3] = Math.max(soup[from]!, soup[from + 3]!, soup[from + 6]!);
      }
    }
    const { bvh, order } = buildBvh(boxes);
    this.#bvh = bvh;
    this.triangles = new Float32Array(count * 9);
    this.#numbers = new Uint32Array(count);
    for (let i = 0; i < count; i++) {
      this.#numbers[i] = numbers[order[i]!]!;
      const from = order[i]! * 9;
      for (let k = 0; k < 9; k++) this.triangles[i * 9 + k] = soup[from + k]!;
    }
    this.#rays = new RayCaster(bvh, this.triangles, this.#numbers);
    this.#leaves = new Uint32Array(this.#bvh.count.reduce((sum, n) => sum + (n > 0 ? 1 : 0), 0));
    const [x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0] = this.#bvh.boxes;
    this.bounds = { min: [x0, y0, z0], max: [x1, y1, z1] };
  }

  /**
   * Nearest hit along a ray, from either side. The next ray overwrites it.
   *
   * @param direction unit
   * @param ignored by number, 1 for triangles that do not count
   */
  raycast(
    origin: Readonly<Vec3>,
    direction: Readonly<Vec3>,
    maxDistance: number,
    ignored: Uint8Array | null = null,
  ): Readonly<RayHit> | null {
    const found = this.#rays.cast(origin, direction, maxDistance, ignored);
    if (found < 0) return null;
    const hit = this.#hit;
    hit.distance = this.#rays.distance;
    hit.u = this.#rays.u;
    hit.v = this.#rays.v;
    hit.triangle = this.#numbers[found / 9]!;
    const { normal } = hit;
    normalOf(this.triangles, found, normal);
    const along = normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2];
    hit.isBack = along > 0;
    if (hit.isBack) for (let axis = 0; axis < 3; axis++) normal[axis] = -normal[axis]!;
    return hit;
  }

  /** Whether nothing lies between two places. */
  isClear(from: Readonly<Vec3>, to: Readonly<Vec3>, ignored: Uint8Array | null = null): boolean {
    const between = this.#between;
    for (let axis = 0; axis < 3; axis++) between[axis] = to[axis]! - from[axis]!;
    return this.#rays.cast(from, between, 1, ignored) < 0;
  }

  /** Whether anything is nearer than `radius` to an upright axis, or in between. */
  overlapsCylinder(place: Readonly<Vec3>, radius: number, height: number): boolean {
    return this.sweepCylinder(place, NO_WAY, { radius, height }).fraction === 0;
  }

  /**
   * Fraction of a level way that an upright cylinder, wider by a margin, can go before it touches anything.
   * The object returned is overwritten by the next call.
   */
  sweepCylinder(
    place: Readonly<Vec3>,
    along: Readonly<Vec3>,
    cylinder: { readonly radius: number; readonly height: number },
    margin = 0,
  ): { readonly fraction: number } {
    const { height } = cylinder;
    const radius = cylinder.radius + margin;
    const dx = along[0];
    const dz = along[2];
    const x = place[0];
    const y = place[1];
    const z = place[2];
    const { link, count } = this.#bvh;
    const leaves = this.#meet(
      Math.min(x, x + dx) - radius,
      y,
      Math.min(z, z + dz) - radius,
      Math.max(x, x + dx) + radius,
      y + height,
      Math.max(z, z + dz) + radius,
    );
    this.#footprint.low = y;
    this.#footprint.high = y + height;
    const way = this.#way;
    way.x = x;
    way.z = z;
    way.dx = dx;
    way.dz = dz;
    way.radius = radius;
    way.fraction = 1;
    for (let leaf = 0; leaf < leaves; leaf++) {
      const node = this.#leaves[leaf]!;
      for (let i = link[node]!, end = i + count[node]!; i < end; i++) {
        if (this.#footprint.clip(this.triangles, i * 9)) this.#footprint.sweep(way);
      }
    }
    return way;
  }

  /** Writes the leaves that meet a box to `#leaves`, and returns how many. */
  #meet(x0: number, y0: number, z0: number, x1: number, y1: number, z1: number): number {
    const { boxes, link, count } = this.#bvh;
    if (link.length === 0) return 0;
    const stack = this.#stack;
    let height = 0;
    let found = 0;
    for (let node = 0; ; ) {
      const box = node * 6;
      const isMet =
        boxes[box]! <= x1 &&
        boxes[box + 3]! >= x0 &&
        boxes[box + 1]! <= y1 &&
        boxes[box + 4]! >= y0 &&
        boxes[box + 2]! <= z1 &&
        boxes[box + 5]! >= z0;
      if (isMet && count[node] === 0) {
        stack[height++] = link[node]! + 1;
        node = link[node]!;
        continue;
      }
      if (isMet) this.#leaves[found++] = node;
      if (height === 0) return found;
      node = stack[--height]!;
    }
  }
}

/** Unit normal of the nine coordinates from `at` on; its length before, twice the area, is returned. */
export function normalOf(triangles: Float32Array, at: number, normal: Vec3): number {
  const ex = triangles[at + 3]! - triangles[at]!;
  const ey = triangles[at + 4]! - triangles[at + 1]!;
  const ez = triangles[at + 5]! - triangles[at + 2]!;
  const fx = triangles[at + 6]! - triangles[at]!;
  const fy = triangles[at + 7]! - triangles[at + 1]!;
  const fz = triangles[at + 8]! - triangles[at + 2]!;
  const x = ey * fz - ez * fy;
  const y = ez * fx - ex * fz;
  const z = ex * fy - ey * fx;
  const length = Math.sqrt(x * x + y * y + z * z);
  const scale = length > 0 ? 1 / length : 0;
  normal[0] = x * scale;
  normal[1] = y * scale;
  normal[2] = z * scale;
  return length;
}

interface Soup {
  /** Nine coordinates each. */
  readonly soup: Float32Array;
  /** Number of each triangle in its parts. */
  readonly numbers: Uint32Array;
}

function gather(parts: readonly Triangles[]): Soup {
  const most = parts.reduce((sum, { indices }) => sum + Math.floor(indices.length / 3), 0);
  const soup = new Float32Array(most * 9);
  const numbers = new Uint32Array(most);
  let end = 0;
  let number = 0;
  for (const { positions, indices } of parts) {
    for (let i = 0; i + 2 < indices.length; i += 3, number++) {
      let sum = 0;
      for (let corner = 0; corner < 3; corner++) {
        const from = indices[i + corner]! * 3;
        const to = end + corner * 3;
        soup[to] = from < positions.length ? positions[from]! : Number.NaN;
        soup[to + 1] = positions[from + 1]!;
        soup[to + 2] = positions[from + 2]!;
        sum += soup[to]! * 0 + soup[to + 1]! * 0 + soup[to + 2]! * 0;
      }
      // NaN if any is not finite, or if an index leads nowhere.
      if (sum !== 0) continue;
      numbers[end / 9] = number;
      end += 9;
    }
  }
  return end === soup.length ? { soup, numbers } : { soup: soup.slice(0, end), numbers };
}

function largest({ soup, numbers }: Soup, most: number): Soup {
  const count = soup.length / 9;
  if (count <= most) return { soup, numbers };
  const normal: Vec3 = [0, 0, 0];
  const areas = Float32Array.from({ length: count }, (_, i) => normalOf(soup, i * 9, normal));
  const least = areas.slice().sort()[count - most]!;
  const largestTriangles = new Float32Array(most * 9);
  const keptNumbers = new Uint32Array(most);
  let end = 0;
  // Those as large as the least come last: there may be more of them than there is room for.
  for (const isTie of [false, true]) {
    for (let i = 0; i < count && end < largestTriangles.length; i++) {
      if (isTie ? areas[i] !== least : areas[i]! <= least) continue;
      largestTriangles.set(soup.subarray(i * 9, i * 9 + 9), end);
      keptNumbers[end / 9] = numbers[i]!;
      end += 9;
    }
  }
  return { soup: largestTriangles, numbers: keptNumbers };
}
