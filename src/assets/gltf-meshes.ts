import type { Accessor, AccessorType, BufferView } from "./gltf-accessors.js";
import type { JsonEntry } from "./json-entry.js";

export type Mesh = Readonly<ReturnType<typeof readMeshes>[number]>;
export type Primitive = Readonly<ReturnType<typeof readPrimitive>>;

interface Lists {
  readonly accessors: readonly Accessor[];
  readonly views: readonly BufferView[];
  readonly materials: readonly JsonEntry[];
}

const TRIANGLES = 4;
const TRIANGLE_FAN = 6;
const ATTRIBUTE_TYPES: readonly (readonly [RegExp, readonly AccessorType[]])[] = [
  [/^(POSITION|NORMAL)$/, ["VEC3"]],
  [/^(TANGENT|JOINTS_0|WEIGHTS_0)$/, ["VEC4"]],
  [/^TEXCOORD_\d$/, ["VEC2"]],
  [/^COLOR_0$/, ["VEC3", "VEC4"]],
];
/** Of a morph target: all that is used of one. */
const TARGET_TYPES: typeof ATTRIBUTE_TYPES = [[/^(POSITION|NORMAL)$/, ["VEC3"]]];
const INDEX_COMPONENTS: readonly number[] = [5121, 5123, 5125];

export function readMeshes(entries: readonly JsonEntry[], lists: Lists) {
  return entries.map((entry, index) => {
    const all = entry.entries("primitives");
    const surfaces = all.filter((primitive) => isTriangles(primitive));
    return {
      name: entry.string("name") ?? `mesh ${index}`,
      primitives: surfaces
        .map((primitive) => readPrimitive(primitive, lists))
        .filter(({ triangles }) => triangles > 0),
      /** Of the morph targets in the rest pose. */
      weights: entry.numbers("weights"),
      /** Whether it has points or lines, which are not drawn. */
      hasLines: surfaces.length < all.length,
    };
  });
}

function isTriangles(primitive: JsonEntry): boolean {
  const mode = primitive.whole("mode") ?? TRIANGLES;
  if (mode > TRIANGLE_FAN) throw primitive.wrong("mode", "is none that is known");
  return mode >= TRIANGLES;
}

function readPrimitive(entry: JsonEntry, { accessors, views, materials }: Lists) {
  const attributes = readAttributes(entry.entry("attributes"), accessors);
  const indices = entry.index("indices", accessors.length);
  const mode = entry.whole("mode") ?? TRIANGLES;
  const count = accessors[indices ?? attributes.POSITION ?? -1]?.count ?? 0;
  if (indices !== undefined) checkIndices(entry, accessors[indices]);
  const reducedIndices = entry.extras()?.index("reducedIndices", accessors.length);
  if (reducedIndices !== undefined) checkIndices(entry, accessors[reducedIndices]);
  const draco = entry.extension("KHR_draco_mesh_compression");
  const targets = entry
    .entries("targets")
    .map((target) => readAttributes(target, accessors, TARGET_TYPES));
  for (const target of targets) {
    const [index = attributes.POSITION] = Object.values(target);
    if (accessors[index ?? -1]?.count !== accessors[attributes.POSITION ?? -1]?.count) {
      throw entry.wrong("targets", "has another count than the positions");
    }
  }
  return {
    /** Accessors by attribute. */
    attributes,
    indices,
    /** Fewer triangles of the same vertices, which our own tools add: tools/models/reduce.mjs. */
    reducedIndices,
    mode,
    material: entry.index("material", materials.length),
    /** As many as the file says. */
    triangles:
      attributes.POSITION === undefined
        ? 0
        : mode === TRIANGLES
          ? Math.floor(count / 3)
          : count - 2,
    targets,
    draco: draco && readDraco(draco, views.length),
  };
}

/** Those that are used here, all as long as the positions. */
function readAttributes(
  entry: JsonEntry | undefined,
  accessors: readonly Accessor[],
  known = ATTRIBUTE_TYPES,
): Record<string, number> {
  const attributes: Record<string, number> = {};
  let count: number | undefined;
  for (const name of entry?.names() ?? []) {
    const types = known.find(([pattern]) => pattern.test(name))?.[1];
    const index = types && entry?.index(name, accessors.length);
    const accessor = accessors[index ?? -1];
    if (!entry || !types || index === undefined || !accessor) continue;
    if (!types.includes(accessor.type)) throw entry.wrong(name, `is not of ${types.join(" or ")}`);
    count ??= accessor.count;
    if (accessor.count !== count) throw entry.wrong(name, "has another count than its fellows");
    attributes[name] = index;
  }
  return attributes;
}

function checkIndices(entry: JsonEntry, accessor: Accessor | undefined): void {
  if (accessor?.type !== "SCALAR" || !INDEX_COMPONENTS.includes(accessor.componentType)) {
    throw entry.wrong("indices", "is not of whole numbers");
  }
}

/** KHR_draco_mesh_compression: the buffer view, and Draco's numbers for the attributes. */
function readDraco(entry: JsonEntry, viewCount: number) {
  const view = entry.index("bufferView", viewCount);
  if (view === undefined) throw entry.wrong("bufferView", "is missing");
  const ids = entry.entry("attributes");
  const attributes: Record<string, number> = {};
  for (const name of ids?.names() ?? []) attributes[name] = ids?.whole(name) ?? 0;
  return { view, attributes };
}
