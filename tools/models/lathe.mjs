import { vec3 } from "gl-matrix";

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
  const isApex = positions.every((position) => vec3.distance(position, positions[0]) < 1e-9);
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
  const between = (to, from) => vec3.subtract([], to, from);
  const down = between(point(distance + difference, angle), point(distance - difference, angle));
  const right = between(point(distance, angle + difference), point(distance, angle - difference));
  return vec3.normalize([], vec3.cross([], down, right));
}

// Angle means nothing on the axis, but a hair's breadth beside it the mean over a turn does.
function apexNormal(beside, angles, point) {
  const sum = [0, 0, 0];
  for (const angle of angles) vec3.add(sum, sum, normalAt(beside, angle, point));
  return vec3.normalize(sum, sum);
}
