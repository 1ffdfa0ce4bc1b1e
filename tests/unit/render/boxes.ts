import type { Model, Part } from "../../../src/assets/model.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";

/** A box; its faces look out, or into the room that it is. */
export function box([x0, y0, z0]: Vec3, [x1, y1, z1]: Vec3, looksOut: boolean): Part {
  const corners: Vec3[] = [0, 1, 2, 3, 4, 5, 6, 7].map((n) => [
    n & 1 ? x1 : x0,
    n & 2 ? y1 : y0,
    n & 4 ? z1 : z0,
  ]);
  const faces = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
  ] as const;
  const indices = faces.flatMap(([a, b, c, d]) =>
    looksOut ? [a, b, c, a, c, d] : [a, c, b, a, d, c],
  );
  return {
    positions: Float32Array.from(corners.flat()),
    uvs: Float32Array.from(corners.flatMap((corner) => corner.slice(0, 2))),
    indices: Uint32Array.from(indices),
    material: { isDoubleSided: false, baseColor: [1, 1, 1, 1], mapOpacity: 1 },
  } as unknown as Part;
}

export function modelOf(...parts: Part[]): Model {
  return { parts, bounds: { min: [0, 0, 0], max: [4, 2, 4] } } as unknown as Model;
}
