/** Plain rooms that light is compared in: boxes and spheres, each of one colour. Lengths in metres. */
import { ShapeUtils, Vector2 } from "three";
import { GlbBuilder } from "../models/glb-builder.mjs";

/** @typedef {readonly [number, number, number]} Triple */
/** @typedef {{ color: Triple, roughness?: number, metallic?: number }} Material of glTF's metallic-roughness model */
/** @typedef {{ min: Triple, max: Triple }} Bounds */
/**
 * @typedef {Bounds & { material: Material, walls?: Partial<Record<Wall, Material>>, isShell?: boolean }} Box
 *   a shell's faces look inward; `walls` are faces of another material
 */
/** @typedef {{ centre: Triple, radius: number, material: Material }} Sphere */
/**
 * @typedef {{ outline: readonly (readonly [x: number, z: number])[], height: number, material: Material }} Prism
 *   a shell over a floor of that outline, counter-clockwise from above
 */
/** @typedef {"-x" | "+x" | "-y" | "+y" | "-z" | "+z"} Wall */

const SPHERE_RINGS = 24;

const matt = (r, g = r, b = r) => ({ color: [r, g, b], roughness: 1 });
const shell = (max, material, walls = {}) => ({
  min: [0, 0, 0],
  max,
  material,
  walls,
  isShell: true,
});
const box = (min, max, material) => ({ min, max, material });
const metal = (color, roughness) => ({ color, roughness, metallic: 1 });

const WHITEWASH = matt(0.8);
const PALE = matt(0.75);
const BLACK = matt(0);
const STEEL = [0.56, 0.57, 0.58];
const BRASS = [0.85, 0.62, 0.3];
/** Partition of 12 cm across two rooms, with a doorway. */
const partition = (sill) => [
  box([3.94, 0, 0], [4.06, 2.6, 1.6], PALE),
  box([3.94, 0, 2.5], [4.06, 2.6, 4], PALE),
  box([3.94, sill, 1.6], [4.06, 2.6, 2.5], PALE),
];

/** @type {Readonly<Record<string, readonly (Box | Sphere)[]>>} */
export const ROOMS = {
  "white-box": [shell([4, 2.6, 4], WHITEWASH), box([2.5, 0, 0.8], [3.3, 0.8, 1.6], WHITEWASH)],
  "coloured-box": [
    shell([4, 2.6, 4], matt(0.7), { "-x": matt(0.6, 0.06, 0.05), "+x": matt(0.12, 0.45, 0.09) }),
    box([0.7, 0, 0.8], [1.4, 1.3, 1.5], matt(0.7)),
    box([2.5, 0, 1.6], [3.2, 0.6, 2.3], matt(0.7)),
  ],
  "two-rooms": [shell([8, 2.6, 4], PALE), ...partition(2), box([6, 0, 0.6], [6.8, 0.9, 1.4], PALE)],
  sealed: [
    shell([10, 2.6, 6], PALE),
    box([4, 0, 0.9], [4.12, 2.6, 6], PALE),
    // A black passage with three bends, through which one gets and no light does.
    ...[
      box([4, 0, 0], [6.9, 2.6, 0.004], BLACK),
      box([4.12, 0, 0.9], [6, 2.6, 1], BLACK),
      box([6.9, 0, 0], [7, 2.6, 4.1], BLACK),
      box([5.9, 0, 1], [6, 2.6, 3.1], BLACK),
      box([5, 0, 4], [6.9, 2.6, 4.1], BLACK),
      box([5, 0, 3], [5.9, 2.6, 3.1], BLACK),
    ],
    ...[
      [0, 0.004],
      [2.596, 2.6],
    ].flatMap(([low, high]) => [
      box([4, low, 0], [6.9, high, 0.9], BLACK),
      box([6, low, 0.9], [6.9, high, 4], BLACK),
      box([5, low, 3.1], [6, high, 4], BLACK),
    ]),
  ],
  straight: [shell([1.3, 2.4, 8], PALE)],
  corridor: [
    {
      outline: [
        [0, 0],
        [0, 5],
        [1.3, 5],
        [1.3, 1.3],
        [5, 1.3],
        [5, 0],
      ],
      height: 2.4,
      material: PALE,
    },
  ],
  niche: [
    shell([4, 2.6, 4], matt(0.6)),
    box([0, 0, 0], [1.2, 2.6, 0.6], matt(0.6)),
    box([2.2, 0, 0], [4, 2.6, 0.6], matt(0.6)),
    box([1.2, 0, 0], [2.2, 0.7, 0.6], matt(0.6)),
    box([1.2, 1.7, 0], [2.2, 2.6, 0.6], matt(0.6)),
  ],
  metals: [
    shell([4, 2.6, 4], matt(0.3, 0.28, 0.25), { "-y": matt(0.25, 0.2, 0.15) }),
    box([0.5, 0, 0.6], [1.1, 0.9, 1.2], metal(BRASS, 0.3)),
    box([2.6, 0, 0.7], [3.3, 0.7, 1.4], { color: [0.25, 0.03, 0.03], roughness: 0.15 }),
    box([1.5, 0, 0.5], [2.1, 0.5, 1.1], metal(STEEL, 0.6)),
    { centre: [1.8, 0.75, 0.8], radius: 0.25, material: metal(STEEL, 0.15) },
    { centre: [2.95, 0.9, 1.05], radius: 0.2, material: metal(BRASS, 0.45) },
  ],
};

/**
 * @param {readonly (Box | Sphere)[]} parts
 * @param {readonly object[]} nodes further nodes of the file, as they are
 * @returns {Buffer} a .glb
 */
export function roomModel(parts, nodes = []) {
  const builder = new GlbBuilder();
  const primitives = parts.flatMap((part) =>
    "radius" in part ? [sphere(part)] : "outline" in part ? walls(part) : faces(part),
  );
  const mesh = builder.add("meshes", { primitives: [] });
  for (const { positions, normals, indices, material } of primitives) {
    const { color, roughness = 1, metallic = 0 } = material;
    builder.json.meshes[mesh].primitives.push({
      attributes: {
        POSITION: builder.accessor(Float32Array.from(positions), 3),
        NORMAL: builder.accessor(Float32Array.from(normals), 3),
      },
      indices: builder.accessor(Uint32Array.from(indices), 1),
      material: builder.add("materials", {
        name: `material-${builder.json.materials?.length ?? 0}`,
        pbrMetallicRoughness: {
          baseColorFactor: [...color, 1],
          roughnessFactor: roughness,
          metallicFactor: metallic,
        },
      }),
    });
  }
  for (const node of [{ mesh }, ...nodes]) builder.root(node);
  return builder.glb();
}

/** One primitive for each face, seen from outside, or of a shell from inside. */
function faces({ min, max, material, walls = {}, isShell = false }) {
  return [0, 1, 2].flatMap((axis) =>
    [0, 1].map((side) => {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const corners = [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ].map(([a, b]) => {
        const ends = [0, 0, 0];
        [ends[axis], ends[u], ends[v]] = [side, a, b];
        return ends.map((end, i) => (end ? max : min)[i]);
      });
      const looksUp = (side === 1) !== isShell;
      const normal = [0, 0, 0];
      normal[axis] = looksUp ? 1 : -1;
      return {
        positions: corners.flat(),
        normals: corners.flatMap(() => normal),
        indices: looksUp ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2],
        material: walls[`${side ? "+" : "-"}${"xyz"[axis]}`] ?? material,
      };
    }),
  );
}

/** Walls of a shell, floor and ceiling. */
function walls({ outline, height, material }) {
  const sides = outline.map(([x, z], i) => {
    const [nextX, nextZ] = outline[(i + 1) % outline.length];
    const length = Math.hypot(nextX - x, nextZ - z);
    const normal = [(nextZ - z) / length, 0, (x - nextX) / length];
    return {
      positions: [x, 0, z, nextX, 0, nextZ, nextX, height, nextZ, x, height, z],
      normals: [normal, normal, normal, normal].flat(),
      indices: [0, 2, 1, 0, 3, 2],
      material,
    };
  });
  const ring = ShapeUtils.triangulateShape(
    outline.map(([x, z]) => new Vector2(x, -z)),
    [],
  );
  const level = (y, up) => ({
    positions: outline.flatMap(([x, z]) => [x, y, z]),
    normals: outline.flatMap(() => [0, up, 0]),
    indices: ring.flatMap((triangle) => (up > 0 ? triangle : triangle.toReversed())),
    material,
  });
  return [...sides, level(0, 1), level(height, -1)];
}

function sphere({ centre, radius, material }) {
  const [positions, normals, indices] = [[], [], []];
  const columns = 2 * SPHERE_RINGS;
  for (let ring = 0; ring <= SPHERE_RINGS; ring++) {
    for (let column = 0; column <= columns; column++) {
      const [polar, around] = [(ring / SPHERE_RINGS) * Math.PI, (column / SPHERE_RINGS) * Math.PI];
      const normal = [
        Math.sin(polar) * Math.cos(around),
        Math.cos(polar),
        -Math.sin(polar) * Math.sin(around),
      ];
      normals.push(...normal);
      positions.push(...normal.map((x, axis) => centre[axis] + radius * x));
      if (ring === SPHERE_RINGS || column === columns) continue;
      const first = ring * (columns + 1) + column;
      const below = first + columns + 1;
      indices.push(first, below, below + 1, first, below + 1, first + 1);
    }
  }
  return { positions, normals, indices, material };
}
