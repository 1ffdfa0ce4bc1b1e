import type { Part } from "../../assets/model.js";
import { type RootedFlame, TAPER } from "../../light/flame-light.js";
import { heightInTapers } from "../../world/flame/burning.js";
import type { Vec3 } from "../../world/geometry.js";
import { CollisionMesh } from "../../world/room/collision-mesh.js";
import { crossOf, verticesOf } from "../mesh/triangles.js";

const POINTS = 192;
/** Share of them that are darker than the key, and its place on the display's scale. */
const KEY = 0.68;
const KEY_VALUE = 0.9;
/** Albedo that all surfaces are metered with, so that dark ones remain dark. */
const ALBEDO = 0.5;
/** Largest exposure of a model, from cd/m² to the display's scale: that of the lone taper. */
export const MOST_EXPOSURE = 5;
/** Least distance of a point from a flame; distance of a point from its surface. Metres. */
const NEAREST = 0.03;
const CLEARANCE = 0.001;
/** Mean diffusion length of wax, m, and the share of the light on its top that leaves below. */
const DIFFUSION_LENGTH = 0.0105;
const WAX_TRANSMITTANCE = 0.2;
/** That of candle/custom-surface.frag, metres. */
const WALL_HEIGHT = 0.012;

interface Point {
  readonly position: Vec3;
  readonly normal: Vec3;
  readonly isWax: boolean;
}

/** Exposure meter of a model alone: by the light of its flames on points of the surfaces that face the camera. */
export class LightMeter {
  /** Of each point and flame: luminance for each candela, cd/m². */
  readonly #perCandela: Float64Array;
  readonly #luminances: Float64Array;
  readonly #collision: CollisionMesh;
  readonly #points: readonly Point[];
  /** Of each flame, metres; 0 before it is metered. */
  readonly #wicks: Float64Array;

  /**
   * @param parts without what light passes, and without wicks
   * @param flames how many
   */
  constructor(parts: readonly Part[], flames: number) {
    this.#collision = new CollisionMesh(parts);
    this.#points = spreadPoints(parts);
    this.#wicks = new Float64Array(flames);
    this.#perCandela = new Float64Array(this.#points.length * flames);
    this.#luminances = new Float64Array(this.#points.length);
  }

  /** Luminance of the key, cd/m², and the exposure: from cd/m² to the display's scale. */
  measure(flames: readonly RootedFlame[]): { readonly key: number; readonly exposure: number } {
    const count = this.#wicks.length;
    for (const [j, { root, flame }] of flames.entries()) {
      if (flame.wick === this.#wicks[j]) continue;
      this.#wicks[j] = flame.wick;
      const height = TAPER.centre * heightInTapers(flame.wick);
      for (const [i, point] of this.#points.entries()) {
        this.#perCandela[i * count + j] = luminanceOf(point, root, height, this.#collision);
      }
    }
    for (let i = 0; i < this.#luminances.length; i++) {
      let sum = 0;
      for (let j = 0; j < count; j++) {
        sum += this.#perCandela[i * count + j]! * (flames[j]?.flame.glow ?? 0);
      }
      this.#luminances[i] = sum;
    }
    const sorted = this.#luminances.toSorted();
    const key = sorted[Math.floor(KEY * sorted.length)] ?? 0;
    return { key, exposure: Math.min(KEY_VALUE / Math.max(key, 1e-6), MOST_EXPOSURE) };
  }
}

/** Luminance of a point by a flame of 1 cd with its middle so high over its root (m), cd/m². */
function luminanceOf(
  { position, normal, isWax }: Point,
  [x, y, z]: Readonly<Vec3>,
  height: number,
  collision: CollisionMesh,
): number {
  const flame: Vec3 = [x, y + height, z];
  const from = position.map((value, axis) => value + normal[axis]! * CLEARANCE) as Vec3;
  const way = flame.map((value, axis) => value - from[axis]!) as Vec3;
  const distance = Math.max(Math.hypot(...way), NEAREST);
  const cosine = way.reduce((sum, value, axis) => sum + value * normal[axis]!, 0) / distance;
  const isLit = cosine > 0 && collision.isClear(from, flame);
  const lit = isLit ? cosine / distance ** 2 : 0;
  const aside = (position[0] - x) ** 2 + (position[2] - z) ** 2;
  const onTop = height / (aside + height ** 2) ** 1.5;
  const depth = Math.max(y - position[1], position[1] - y - WALL_HEIGHT, 0);
  const glow = isWax ? WAX_TRANSMITTANCE * onTop * Math.exp(-depth / DIFFUSION_LENGTH) : 0;
  return (ALBEDO / Math.PI) * (lit + glow);
}

/** Middles of triangles, evenly spread over the area that faces forwards or up. */
function spreadPoints(parts: readonly Part[]): Point[] {
  const total = parts.reduce((sum, part) => sum + walk(part, () => {}), 0);
  const points: Point[] = [];
  let begin = 0;
  for (const part of parts) {
    const { isWax } = part.material;
    begin += walk(part, (position, normal, before, area) => {
      const [first, next] = [before, before + area].map((at) =>
        Math.floor(((begin + at) / total) * POINTS),
      );
      for (let i = first!; i < next!; i++) points.push({ position, normal, isWax });
    });
  }
  return points;
}

/** Visits the triangles of a part that face forwards or up. Returns their area, m². */
function walk(
  part: Part,
  visit: (middle: Vec3, normal: Vec3, before: number, area: number) => void,
): number {
  let sum = 0;
  for (let triangle = 0; 3 * triangle + 2 < part.indices.length; triangle++) {
    const corners = verticesOf(part, triangle);
    const [a, b, c] = corners;
    const normal = crossOf(corners);
    const twice = Math.hypot(...normal);
    if (!(twice > 0) || normal[1] + normal[2] <= 0) continue;
    for (const axis of [0, 1, 2] as const) normal[axis] /= twice;
    const middle: Vec3 = [0, 1, 2].map((axis) => (a[axis]! + b[axis]! + c[axis]!) / 3) as Vec3;
    visit(middle, normal, sum, twice / 2);
    sum += twice / 2;
  }
  return sum;
}
