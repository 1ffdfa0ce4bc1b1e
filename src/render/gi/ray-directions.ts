import type { Vec3 } from "../../world/geometry.js";

/**
 * Directions of an octahedral map's texels, row by row, with a border that continues across the seam.
 *
 * Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".
 *
 * @param width texels along an edge, border included
 * @param size the same without it
 */
export function octahedral(width: number, size: number, border: number): Vec3[] {
  return Array.from({ length: width * width }, (_, n) => {
    let u = (((n % width) + 0.5 - border) / size) * 2 - 1;
    let v = ((Math.floor(n / width) + 0.5 - border) / size) * 2 - 1;
    if (Math.abs(u) > 1) [u, v] = [Math.sign(u) * 2 - u, -v];
    if (Math.abs(v) > 1) [u, v] = [-u, Math.sign(v) * 2 - v];
    const y = 1 - Math.abs(u) - Math.abs(v);
    const x = y < 0 ? (1 - Math.abs(v)) * (u < 0 ? -1 : 1) : u;
    const z = y < 0 ? (1 - Math.abs(u)) * (v < 0 ? -1 : 1) : v;
    const length = Math.hypot(x, y, z);
    return [x / length, y / length, z / length];
  });
}

/**
 * Directions of a probe's rays, turned about (1, 1, 1), a 24th of a full turn for each corner of a cell: the eight probes
 * around a point look in other directions, and a doorway that one's rays miss is met by another's. `turnOf` of
 * `lib/probe-rays.glsl`.
 */
export function rayDirections(rays: number, corner: number): Vec3[] {
  const angle = (corner * 2 * Math.PI) / 24;
  const [rest, sine] = [(1 - Math.cos(angle)) / 3, Math.sin(angle) / Math.sqrt(3)];
  const [a, b, c] = [1 - 2 * rest, rest - sine, rest + sine];
  return octahedral(rays, rays, 0).map(([x, y, z]) => [
    a * x + b * y + c * z,
    c * x + a * y + b * z,
    b * x + c * y + a * z,
  ]);
}
