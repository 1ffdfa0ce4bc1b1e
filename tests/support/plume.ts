import { trilinear } from "../../src/world/air/plume-grid.ts";
import { type PlumeSolver, ROOM_TEMPERATURE } from "../../src/world/air/plume-solver.ts";
import type { Vec3 } from "../../src/world/geometry.ts";

/** Temperature of a plume at a place in the room, kelvin. */
export function temperatureAt({ grid, heat, origin }: PlumeSolver, place: Readonly<Vec3>): number {
  const { x, y, z } = grid;
  const at: Vec3 = [
    x.place(place[0] - origin[0]) - 0.5,
    y.place(place[1] - origin[1]) - 0.5,
    z.place(place[2] - origin[2]) - 0.5,
  ];
  const excess: Vec3 = [0, 0, 0];
  trilinear(heat, x.count, y.count, z.count, at, excess, 0);
  return ROOM_TEMPERATURE * (1 + excess[0]);
}

/** Largest share by which a cell's inflow and outflow differ, against the fastest rise. */
export function divergenceOf({ grid: { x, y, z }, velocities: [u, v, w] }: PlumeSolver): number {
  const at = (field: Float64Array, index: number) => field[index] ?? Number.NaN;
  const width = (axis: typeof x, cell: number) => at(axis.widths, cell);
  let most = 0;
  for (let k = 0; k < z.count; k++) {
    for (let j = 0; j < y.count; j++) {
      for (let i = 0; i < x.count; i++) {
        const across = i + (x.count + 1) * (j + y.count * k);
        const up = i + x.count * (j + (y.count + 1) * k);
        const along = i + x.count * (j + y.count * k);
        const excess =
          (at(u, across + 1) - at(u, across)) / width(x, i) +
          (at(v, up + x.count) - at(v, up)) / width(y, j) +
          (at(w, along + x.count * y.count) - at(w, along)) / width(z, k);
        most = Math.max(most, Math.abs(excess));
      }
    }
  }
  const fastest = v.reduce((fastest, speed) => Math.max(fastest, Math.abs(speed)), 0);
  return (most * width(x, x.count >> 1)) / fastest;
}
