import { packGlb } from "../../tools/models/glb-builder.mjs";

type Point = readonly [x: number, y: number];

/** A figure of revolution: its outline from the axis or from below, and where it stands. Metres. */
interface Turned {
  readonly material: string;
  readonly outline: readonly Point[];
  readonly at: readonly [x: number, z: number];
}

const SIDES = 32;

const MATERIALS: Readonly<Record<string, object>> = {
  plate: {
    pbrMetallicRoughness: {
      baseColorFactor: [0.6, 0.62, 0.65, 1],
      roughnessFactor: 0.35,
      metallicFactor: 0,
    },
  },
  wax: {
    pbrMetallicRoughness: {
      baseColorFactor: [0.86, 0.78, 0.64, 1],
      roughnessFactor: 0.5,
      metallicFactor: 0,
    },
  },
  wick: {
    pbrMetallicRoughness: {
      baseColorFactor: [0.05, 0.04, 0.04, 1],
      roughnessFactor: 1,
      metallicFactor: 0,
    },
  },
  glass: {
    doubleSided: true,
    pbrMetallicRoughness: {
      baseColorFactor: [1, 1, 1, 1],
      roughnessFactor: 0.04,
      metallicFactor: 0,
    },
    extensions: { KHR_materials_transmission: { transmissionFactor: 1 } },
  },
};

/** Positions, normals and triangles of a figure of revolution, flat along its outline and smooth around. */
function turn({ outline, at: [cx, cz] }: Turned) {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (const [i, [r0, y0]] of outline.entries()) {
    const [r1, y1] = outline[i + 1] ?? [Number.NaN, 0];
    if (Number.isNaN(r1)) continue;
    const length = Math.hypot(r1 - r0, y1 - y0);
    const [nr, ny] = [(y1 - y0) / length, (r0 - r1) / length];
    const first = positions.length / 3;
    for (let side = 0; side <= SIDES; side++) {
      const angle = (2 * Math.PI * side) / SIDES;
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      for (const [r, y] of [
        [r0, y0],
        [r1, y1],
      ] as const) {
        positions.push(cx + r * cos, y, cz + r * sin);
        normals.push(nr * cos, ny, nr * sin);
      }
    }
    for (let side = 0; side < SIDES; side++) {
      const [a, b, c, d] = [0, 1, 2, 3].map((corner) => first + side * 2 + corner);
      indices.push(a!, b!, c!, c!, b!, d!);
    }
  }
  return { positions, normals, indices };
}

/** Figures of revolution and wicks as a .glb. */
function packTurned(figures: readonly Turned[], nodes: readonly object[]): Buffer {
  const chunks: Buffer[] = [];
  const bufferViews: object[] = [];
  const accessors: object[] = [];
  let length = 0;
  const add = (data: Float32Array | Uint32Array, type: string, extra: object = {}) => {
    const bytes = Buffer.from(data.buffer);
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
    const componentType = data instanceof Float32Array ? 5126 : 5125;
    const count = data.length / (type === "VEC3" ? 3 : 1);
    accessors.push({ bufferView: bufferViews.length - 1, componentType, count, type, ...extra });
    chunks.push(bytes);
    length += bytes.length;
    return accessors.length - 1;
  };
  const names = Object.keys(MATERIALS);
  const meshes = figures.map((figure) => {
    const { positions, normals, indices } = turn(figure);
    const axis = (i: number) => positions.filter((_, at) => at % 3 === i);
    const box = {
      min: [0, 1, 2].map((i) => Math.min(...axis(i))),
      max: [0, 1, 2].map((i) => Math.max(...axis(i))),
    };
    const attributes = {
      POSITION: add(Float32Array.from(positions), "VEC3", box),
      NORMAL: add(Float32Array.from(normals), "VEC3"),
    };
    const primitive = {
      attributes,
      indices: add(Uint32Array.from(indices), "SCALAR"),
      material: names.indexOf(figure.material),
    };
    return { primitives: [primitive] };
  });
  const all = [...meshes.map((_, mesh) => ({ mesh })), ...nodes];
  return packGlb(
    {
      asset: { version: "2.0" },
      extensionsUsed: ["KHR_materials_transmission"],
      scene: 0,
      scenes: [{ nodes: all.map((_, i) => i) }],
      nodes: all,
      meshes,
      materials: names.map((name) => ({ name, ...MATERIALS[name] })),
      buffers: [{ byteLength: length }],
      bufferViews,
      accessors,
    },
    Buffer.concat(chunks),
  );
}

interface Candle {
  readonly at: readonly [x: number, z: number];
  /** Of the wax: from the plate up, and its radius. */
  readonly height: number;
  readonly radius: number;
}

/** Candles of wax on a round plate, each with its wick: `wick`, `wick.001`, … */
export function candlePlate(candles: readonly Candle[], plate: number): Buffer {
  const figures = candles.flatMap(({ at, height, radius }): Turned[] => [
    {
      material: "wax",
      at,
      outline: [
        [radius, 0],
        [radius, height - 0.002],
        [radius - 0.002, height],
        [0.4 * radius, height - 0.002],
        [0, height - 0.003],
      ],
    },
    {
      material: "wick",
      at,
      outline: [
        [0.001, height - 0.004],
        [0.001, height + 0.007],
        [0, height + 0.0075],
      ],
    },
  ]);
  const rim: Turned = {
    material: "plate",
    at: [0, 0],
    outline: [
      [0, -0.012],
      [plate - 0.01, -0.012],
      [plate, 0.004],
      [plate - 0.004, 0.004],
      [plate - 0.014, 0],
      [0, 0],
    ],
  };
  return packTurned(
    [rim, ...figures],
    candles.map(({ at: [x, z], height }, i) => wickNode(i, [x, height, z])),
  );
}

/** A candle in a jar of glass, of one wall or two. */
export function jarCandle(): Buffer {
  const glass: Turned = {
    material: "glass",
    at: [0, 0],
    outline: [
      [0, 0],
      [0.038, 0],
      [0.04, 0.004],
      [0.04, 0.1],
      [0.037, 0.1],
      [0.037, 0.006],
      [0, 0.006],
    ],
  };
  const wax: Turned = {
    material: "wax",
    at: [0, 0],
    outline: [
      [0, 0.0065],
      [0.0365, 0.0065],
      [0.0365, 0.048],
      [0.02, 0.0465],
      [0, 0.046],
    ],
  };
  const wick: Turned = {
    material: "wick",
    at: [0, 0],
    outline: [
      [0.001, 0.045],
      [0.001, 0.053],
      [0, 0.0535],
    ],
  };
  return packTurned([glass, wax, wick], [wickNode(0, [0, 0.047, 0])]);
}

function wickNode(i: number, translation: readonly number[]): object {
  return { name: i === 0 ? "wick" : `wick.${String(i).padStart(3, "0")}`, translation };
}

/** Candles in a ring, the first one in front. */
export function ringOf(count: number, distance: number, height: number, radius: number): Candle[] {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count + Math.PI / 4;
    return {
      at: [distance * Math.cos(angle), distance * Math.sin(angle)] as const,
      height,
      radius,
    };
  });
}
