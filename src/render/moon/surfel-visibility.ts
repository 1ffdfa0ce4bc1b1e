import { vec3 } from "gl-matrix";
import type { Vec3 } from "../../world/geometry.js";
import { pcg } from "../../world/random.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import type { Steps } from "../../world/steps.js";
import { surfelRowsOf } from "../gi/indirect-targets.js";
import type { LightRays } from "../gi/light-rays.js";
import type { IndirectDetail } from "../gi/probe-rays.js";
import { pointOn } from "../points.js";
import { FACES } from "../shadow/cube-map.js";
import type { MoonFrustum } from "./moon-frustum.js";
import type { LitPoint } from "./virtual-lights.js";

/** What is nearer to a surfel than this does not hide it, metres. */
const NEAR = 0.03;
/** Depth of what the light meets at a window, from its panes, metres: it goes back outdoors. */
const SASH = 0.02;
/** Probes in a step. */
const PROBES = 12;

/** Whether surfels are visible from probes: 255 or 0, in the tiles of `gi/surfel-radiance.frag`, row by row. */
export interface SurfelVisibility {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array;
}

/** What the moon lights at each of its surfels, as `lib/surfels.glsl` has them; null where its light meets nothing. */
export function moonlitPoints(
  { corner, across, up, direction, depth, panes }: MoonFrustum,
  casters: CollisionMesh,
  { surfels: size, surfelGroup: paneRows }: IndirectDetail,
): (LitPoint | null)[] {
  const columns = FACES.length * size;
  const rows = size - paneRows;
  return Array.from({ length: columns * size }, (_, i) => {
    const column = ((i % columns) + 0.5) / columns;
    const row = Math.floor(i / columns) + 0.5;
    if (row > rows) {
      if (!panes) return null;
      const share = (row - rows) / paneRows;
      const position = pointOn(panes.corner, panes.across, panes.up, column, share);
      return { position, normal: panes.normal, isPane: true };
    }
    const start = pointOn(corner, across, up, column, row / rows);
    const hit = casters.raycast(start, direction, depth);
    if (!hit) return null;
    const position = pointOn(start, direction, up, hit.distance, 0);
    if (panes && vec3.dot(vec3.subtract([0, 0, 0], position, panes.corner), panes.normal) < SASH) {
      return null;
    }
    return { position, normal: [...hit.normal], isPane: false };
  });
}

/**
 * Traces which of the moon's surfels each probe sees, one of each group.
 *
 * Its light comes from one place, so that a table's shadow is narrower than a few of a probe's own rays.
 *
 * @param lit what the moon lights
 * @param probes (x, y, z, 1) of each, metres; the last is 0 for one inside a solid, which sees nothing
 */
export function* traceSurfelVisibility(
  lit: readonly (LitPoint | null)[],
  light: Pick<LightRays, "isClear">,
  probes: Float32Array,
  detail: IndirectDetail,
): Steps<SurfelVisibility> {
  const { rays, surfelGroup: group } = detail;
  const [columns, rows, planes] = detail.probes;
  const surfelRows = surfelRowsOf(detail);
  const surfelColumns = FACES.length * detail.surfels;
  const groupColumns = surfelColumns / group;
  const groups = groupColumns * (detail.surfels / group);
  const [width, height] = [columns * rays, rows * planes * surfelRows];
  const data = new Uint8Array(width * height);
  const probe: Vec3 = [0, 0, 0];
  const end: Vec3 = [0, 0, 0];
  for (let tile = 0; tile < columns * rows * planes; tile++) {
    if (tile % PROBES === PROBES - 1) yield;
    if (probes[4 * tile + 3] === 0) continue;
    const tileColumn = tile % columns;
    const tileRow = Math.floor(tile / columns);
    for (const axis of [0, 1, 2] as const) probe[axis] = probes[4 * tile + axis]!;
    for (let i = 0; i < groups; i++) {
      const column = i % groupColumns;
      const row = Math.floor(i / groupColumns);
      // The one that the shader takes.
      const chance = pcg((column + 8192 * row + pcg(tileColumn + 8192 * tileRow)) >>> 0);
      const surfelColumn = column * group + (((chance >>> 8) & 4095) % group);
      const surfelRow = row * group + ((chance >>> 20) % group);
      const surfel = lit[surfelRow * surfelColumns + surfelColumn];
      if (!surfel) continue;
      const [x, y, z] = surfel.position;
      const distance = Math.hypot(x - probe[0], y - probe[1], z - probe[2]);
      const share = Math.max(1 - NEAR / distance, 0);
      for (const axis of [0, 1, 2] as const) {
        end[axis] = probe[axis] + share * (surfel.position[axis] - probe[axis]);
      }
      if (!light.isClear(probe, end)) continue;
      const line = tileRow * surfelRows + Math.floor(i / rays);
      data[line * width + tileColumn * rays + (i % rays)] = 255;
    }
  }
  return { width, height, data };
}
