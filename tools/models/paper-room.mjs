/**
 * The paper's room: the inside of a box, 10 × 3.2 × 10 m, its origin on the floor in the middle. The
 * faces are cut into squares of about a metre, so that light computed per vertex has somewhere to land.
 */
import { vec3 } from "gl-matrix";
import { writeModel } from "./gltf.mjs";
import { joined } from "./lathe.mjs";

const width = 10;
const height = 3.2;
const half = width / 2;
const centre = [0, height / 2, 0];

const logTile = 1.6;
const plankTile = 1.6;
const plasterTile = 2;

/** A rectangle seen from the room: `right` and `down` are its edges from the upper left `corner`. */
function rectangle({ corner, right, down, columns, rows, tile, from = 0 }) {
  const [across, along] = [Math.hypot(...right), Math.hypot(...down)];
  const normal = vec3.normalize([], vec3.cross([], down, right));
  const triangles = { positions: [], normals: [], texcoords: [] };
  const emit = (column, row) => {
    const [u, v] = [column / columns, row / rows];
    triangles.positions.push(
      ...corner.map((start, axis) => start + right[axis] * u + down[axis] * v),
    );
    triangles.normals.push(...normal);
    triangles.texcoords.push((from + across * u) / tile, (along * v) / tile);
  };

  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      emit(column, row);
      emit(column, row + 1);
      emit(column + 1, row + 1);
      emit(column, row);
      emit(column + 1, row + 1);
      emit(column + 1, row);
    }
  }
  return triangles;
}

// Clockwise from north as one turns to the right. The logs run on through the corners, and four
// walls of 6.25 tiles close upon themselves.
const walls = [
  { corner: [-half, height, -half], right: [width, 0, 0] },
  { corner: [half, height, -half], right: [0, 0, width] },
  { corner: [half, height, half], right: [-width, 0, 0] },
  { corner: [-half, height, half], right: [0, 0, -width] },
].map((wall, index) =>
  rectangle({
    ...wall,
    down: [0, -height, 0],
    columns: 10,
    rows: 4,
    tile: logTile,
    from: index * width,
  }),
);

const floor = rectangle({
  corner: [-half, 0, -half],
  right: [width, 0, 0],
  down: [0, 0, width],
  columns: 10,
  rows: 10,
  tile: plankTile,
});

const ceiling = rectangle({
  corner: [-half, height, half],
  right: [width, 0, 0],
  down: [0, 0, -width],
  columns: 10,
  rows: 10,
  tile: plasterTile,
});

await writeModel(new URL("../../public/models/paper-room.glb", import.meta.url), {
  materials: [
    { name: "logs", textures: "logs" },
    { name: "planks", textures: "planks" },
    { name: "plaster", textures: "plaster" },
  ],
  meshes: [
    { name: "walls", material: "logs", triangles: joined(...walls), centre, facing: -1 },
    { name: "floor", material: "planks", triangles: floor, centre, facing: -1 },
    { name: "ceiling", material: "plaster", triangles: ceiling, centre, facing: -1 },
  ],
});
