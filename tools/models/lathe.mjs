/**
 * A lathe turns a profile about an axis. `point(distance, angle)` gives the surface, so the work may
 * be as uneven as a candle. Distance runs down the outside of the work and angle to the right as
 * seen from there: the two are the texture's V and U, and dP/ddistance × dP/dangle faces outwards.
 *
 * The triangles come unwelded, as MikkTSpace wants them.
 */

const difference = 1e-4;

/**
 * @param {object} work
 * @param {number[]} work.distances where the rings are, in the profile's own order
 * @param {number} work.segments around the axis
 * @param {(distance: number, angle: number) => number[]} work.point
 * @param {(distance: number, turn: number, position: number[]) => number[]} work.texcoord turn is 0..1
 */
export function lathe({ distances, segments, point, texcoord }) {
  const rings = distances.map((distance, ring) => {
    const inwards = ring === 0 ? 1 : -1;
    return ringAt(distance, inwards * difference, segments, point);
  });
  const triangles = { positions: [], normals: [], texcoords: [] };

  const emit = (ring, column, turn) => {
    const { distance, positions, normals } = rings[ring];
    const position = positions[column % segments];
    triangles.positions.push(...position);
    triangles.normals.push(...normals[column % segments]);
    triangles.texcoords.push(...texcoord(distance, turn / segments, position));
  };

  for (let ring = 0; ring + 1 < rings.length; ring++) {
    for (let column = 0; column < segments; column++) {
      const upperApex = rings[ring].isApex;
      const lowerApex = rings[ring + 1].isApex;
      const next = column + 1;
      if (!lowerApex) {
        emit(ring, column, upperApex ? column + 0.5 : column);
        emit(ring + 1, column, column);
        emit(ring + 1, next, next);
      }
      if (!upperApex) {
        emit(ring, column, column);
        emit(ring + 1, next, lowerApex ? column + 0.5 : next);
        emit(ring, next, next);
      }
    }
  }
  return triangles;
}

/** Two lathes with their own texture coordinates become one surface: their shared ring is one curve. */
export function joined(...surfaces) {
  return {
    positions: surfaces.flatMap((surface) => surface.positions),
    normals: surfaces.flatMap((surface) => surface.normals),
    texcoords: surfaces.flatMap((surface) => surface.texcoords),
  };
}

function ringAt(distance, inwards, segments, point) {
  const angles = Array.from({ length: segments }, (_, column) => (2 * Math.PI * column) / segments);
  const positions = angles.map((angle) => point(distance, angle));
  const normals = angles.map((angle) => normalAt(distance, angle, point));
  const isApex = positions.every((position) => length(subtract(position, positions[0])) < 1e-9);
  if (!isApex) return { distance, positions, normals, isApex };

  const axis = apexNormal(distance + inwards, angles, point);
  return {
    distance,
    positions: positions.map(() => positions[0]),
    normals: normals.map(() => axis),
    isApex,
  };
}

function normalAt(distance, angle, point) {
  const down = subtract(point(distance + difference, angle), point(distance - difference, angle));
  const right = subtract(point(distance, angle + difference), point(distance, angle - difference));
  return normalized(cross(down, right));
}

// Angle means nothing on the axis, but a hair's breadth beside it the mean over a turn does.
function apexNormal(beside, angles, point) {
  const sum = [0, 0, 0];
  for (const angle of angles) {
    const normal = normalAt(beside, angle, point);
    for (let axis = 0; axis < 3; axis++) sum[axis] += normal[axis];
  }
  return normalized(sum);
}

export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const normalized = (a) => {
  const scale = 1 / length(a);
  return [a[0] * scale, a[1] * scale, a[2] * scale];
};
