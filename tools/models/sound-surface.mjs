import { vec3 } from "gl-matrix";

const { dot, length } = vec3;
const subtract = (a, b) => vec3.subtract([], a, b);
const cross = (a, b) => vec3.cross([], a, b);

/**
 * Refuses a mesh that would light wrongly: inside out, with normals its triangles do not support, or
 * with a tangent frame that does not follow its texture. `centre` must see every triangle's same side.
 */
export function assertSoundSurface({ name, centre, facing }, arrays) {
  const { positions, normals, tangents, texcoords, indices } = arrays;
  const demand = (holds, what, vertex) => {
    if (!holds) throw new Error(`${name}: ${what} at vertex ${vertex}`);
  };
  const vector = (array, vertex, width) => array.subarray(vertex * width, vertex * width + 3);

  for (let vertex = 0; vertex < positions.length / 3; vertex++) {
    const normal = vector(normals, vertex, 3);
    const tangent = vector(tangents, vertex, 4);
    demand(Math.abs(length(normal) - 1) < 1e-5, "normal is not of unit length", vertex);
    demand(Math.abs(length(tangent) - 1) < 1e-5, "tangent is not of unit length", vertex);
    demand(Math.abs(dot(normal, tangent)) < 1e-4, "tangent leans out of the surface", vertex);
    demand(Math.abs(tangents[vertex * 4 + 3]) === 1, "handedness is not ±1", vertex);
  }

  for (let first = 0; first < indices.length; first += 3) {
    const corners = indices.subarray(first, first + 3);
    const [a, b, c] = Array.from(corners, (corner) => vector(positions, corner, 3));
    const doubleArea = cross(subtract(b, a), subtract(c, a));
    demand(length(doubleArea) > 1e-9, "triangle has no area", corners[0]);
    const face = vec3.normalize([], doubleArea);
    demand(facing * dot(face, subtract(a, centre)) > 0, "triangle faces the wrong way", corners[0]);

    const { alongU, alongV } = textureDirections(corners, [a, b, c], texcoords);
    for (const vertex of corners) {
      const normal = vector(normals, vertex, 3);
      const tangent = vector(tangents, vertex, 4);
      // Texture V runs down the image, and a normal map's green points up it.
      const bitangent = cross(normal, tangent).map((value) => value * tangents[vertex * 4 + 3]);
      demand(dot(face, normal) > 0.8, "normal disagrees with its triangle", vertex);
      demand(dot(tangent, alongU) > 0.8, "tangent does not follow texture U", vertex);
      demand(dot(bitangent, alongV) < -0.8, "bitangent does not oppose texture V", vertex);
    }
  }
}

/** Unit dP/du and dP/dv of one triangle. */
function textureDirections(corners, [a, b, c], texcoords) {
  const [ua, va, ub, vb, uc, vc] = Array.from(corners).flatMap((corner) => [
    texcoords[corner * 2],
    texcoords[corner * 2 + 1],
  ]);
  const determinant = (ub - ua) * (vc - va) - (uc - ua) * (vb - va);
  const [ab, ac] = [subtract(b, a), subtract(c, a)];
  const combine = (left, right) =>
    vec3.normalize(
      [],
      ab.map((value, axis) => (value * left + ac[axis] * right) / determinant),
    );
  return { alongU: combine(vc - va, va - vb), alongV: combine(ua - uc, ub - ua) };
}
