import { Flaw } from "./asset-error.js";
import { type Accessor, readAccessors, readViews } from "./gltf-accessors.js";
import { type Mesh, readMeshes } from "./gltf-meshes.js";
import { JsonEntry } from "./json-entry.js";

/**
 * The parts of a glTF file that are used here. All references and numbers are validated: there are no cycles and no
 * indices out of bounds.
 */
export type GltfDocument = Readonly<ReturnType<typeof readDocument>>;
export type Node = Readonly<ReturnType<typeof readNode>>;

interface Lists {
  readonly meshes: readonly Mesh[];
  readonly skins: readonly unknown[];
  readonly accessors: readonly Accessor[];
}

/** Most levels of the node tree: recursion over more runs out of stack. */
const MOST_DEPTH = 500;
const MOST_NODES = 100_000;
const MOST_TRIANGLES = 5e6;
/** Most vertices: those of `MOST_TRIANGLES` without shared vertices, since a small file can ask for any number. */
const MOST_VERTICES = 3 * MOST_TRIANGLES;

export function readDocument(json: unknown) {
  const root = new JsonEntry(json, "");
  const version = root.entry("asset")?.string("version");
  if (version === undefined) throw new Flaw("is no glTF: it does not say of which version it is");
  if (!/^2(\.|$)/.test(version)) throw new Flaw(`is glTF ${version}, and only glTF 2 can be read`);

  const buffers = root.entries("buffers").map((buffer) => ({
    uri: buffer.string("uri"),
    byteLength: buffer.whole("byteLength") ?? 0,
  }));
  const views = readViews(root.entries("bufferViews"), buffers);
  const accessors = readAccessors(root.entries("accessors"), views);
  const materials = root.entries("materials");
  const meshes = readMeshes(root.entries("meshes"), { accessors, views, materials });
  const nodeEntries = root.entries("nodes");
  checkCount("nodes", nodeEntries.length, MOST_NODES);
  const skins = root.entries("skins").map((skin) => readSkin(skin, nodeEntries.length, accessors));
  const lists = { meshes, skins, accessors };
  const nodes = nodeEntries.map((node) => readNode(node, nodeEntries.length, lists));
  const scenes = root.entries("scenes");
  const roots = rootsOf(root, scenes, nodes);
  checkTree(nodes, roots);
  const shown = [...roots];
  for (const index of shown) shown.push(...(nodes[index]?.children ?? []));
  checkTriangles(shown, nodes, { meshes, accessors });
  return {
    /** Nodes of the scene shown that have no parent. */
    roots,
    /** Those and all below them. */
    shown,
    nodes,
    meshes,
    skins,
    accessors,
    views,
    buffers,
    /** Read by `read-material.ts` and `texture-images.ts`, where they are used. */
    materials,
    textures: root.entries("textures"),
    images: root.entries("images"),
    samplers: root.entries("samplers"),
    extensionsUsed: root.strings("extensionsUsed"),
    sceneCount: scenes.length,
    hasAnimations: root.entries("animations").length > 0,
  };
}

function readNode(entry: JsonEntry, count: number, { meshes, skins, accessors }: Lists) {
  const index = entry.index("mesh", meshes.length);
  const mesh = index === undefined ? undefined : meshes[index];
  const name = entry.string("name") ?? "";
  const isCandle = /^(wick|flame)(?![a-z])/.test(name);
  const placement = isCandle ? readLeniently(entry) : readPlacement(entry);
  const isSeen = mesh !== undefined && mesh.primitives.length > 0 && placement !== null;
  return {
    name,
    children: entry.indices("children", count),
    mesh: isSeen ? index : undefined,
    /** Whether it has no mesh at all, not even one of lines. */
    isEmpty: mesh === undefined,
    skin: isSeen ? entry.index("skin", skins.length) : undefined,
    weights: isSeen ? entry.numbers("weights") : undefined,
    /** Whether it is a wick, or the flame of one, whose position is not finite. */
    isMisplaced: placement === null,
    /** As in the file: millimetres, not validated. */
    wickDiameter: isCandle ? entry.extras()?.value("wickDiameter") : undefined,
    ...placement,
    /** Accessors of EXT_mesh_gpu_instancing. */
    instances: isSeen ? readInstances(entry, accessors) : undefined,
  };
}

function readPlacement(entry: JsonEntry) {
  return {
    matrix: entry.numbers("matrix", 16),
    translation: entry.numbers("translation", 3),
    rotation: unit(entry.numbers("rotation", 4)),
    scale: entry.numbers("scale", 3),
  };
}

/** Null for invalid numbers: a missing candle, or its mesh, is no reason to refuse a model. */
function readLeniently(entry: JsonEntry): ReturnType<typeof readPlacement> | null {
  try {
    return readPlacement(entry);
  } catch {
    return null;
  }
}

function unit(quaternion: number[] | undefined): number[] | undefined {
  const length = Math.hypot(...(quaternion ?? []));
  return length > 0 ? quaternion?.map((component) => component / length) : undefined;
}

const INSTANCE_TYPES = { TRANSLATION: "VEC3", ROTATION: "VEC4", SCALE: "VEC3" } as const;

function readInstances(node: JsonEntry, accessors: readonly Accessor[]) {
  const attributes = node.extension("EXT_mesh_gpu_instancing")?.entry("attributes");
  if (!attributes) return undefined;
  const instances: Record<string, number> = {};
  const counts = new Set<number>();
  for (const [name, type] of Object.entries(INSTANCE_TYPES)) {
    const index = attributes.index(name, accessors.length);
    const accessor = index === undefined ? undefined : accessors[index];
    if (index === undefined || !accessor) continue;
    if (accessor.type !== type) throw attributes.wrong(name, `is not of ${type}`);
    instances[name] = index;
    counts.add(accessor.count);
  }
  if (counts.size > 1) throw attributes.wrong("TRANSLATION", "has another count than its fellows");
  return counts.size === 1 ? instances : undefined;
}

function readSkin(entry: JsonEntry, nodeCount: number, accessors: readonly Accessor[]) {
  const joints = entry.indices("joints", nodeCount);
  if (joints.length === 0) throw entry.wrong("joints", "is empty");
  const inverseBindMatrices = entry.index("inverseBindMatrices", accessors.length);
  if (inverseBindMatrices !== undefined) {
    const matrices = accessors[inverseBindMatrices];
    if (matrices?.type !== "MAT4" || matrices.componentType !== 5126) {
      throw entry.wrong("inverseBindMatrices", "is not of matrices");
    }
    if (matrices.count < joints.length) {
      throw entry.wrong("inverseBindMatrices", "has fewer matrices than there are joints");
    }
  }
  return { joints, inverseBindMatrices };
}

/** Root nodes of the default scene, or of the whole file where it has no scenes. */
function rootsOf(root: JsonEntry, scenes: readonly JsonEntry[], nodes: readonly Node[]): number[] {
  const scene = scenes[root.index("scene", scenes.length) ?? 0];
  if (scene) return [...new Set(scene.indices("nodes", nodes.length))];
  const children = new Set(nodes.flatMap((node) => node.children));
  return nodes.flatMap((_, index) => (children.has(index) ? [] : [index]));
}

function checkTree(nodes: readonly Node[], roots: readonly number[]): void {
  const parents = new Map<number, number>();
  for (const [parent, { children }] of nodes.entries()) {
    for (const child of children) {
      if (parents.has(child)) throw new Flaw(`is broken: nodes[${child}] has two parents`);
      parents.set(child, parent);
    }
  }
  checkDepths(nodes.length, parents);
  for (const root of roots) {
    if (parents.has(root)) throw new Flaw(`is broken: nodes[${root}] is a root and has a parent`);
  }
}

/** Refuses cycles and deep trees. A node has one parent at most, so the way up from it ends or repeats. */
function checkDepths(count: number, parents: ReadonlyMap<number, number>): void {
  const depths = new Map<number, number>();
  for (let start = 0; start < count; start++) {
    const path = new Set<number>();
    let node: number | undefined = start;
    while (node !== undefined && !depths.has(node)) {
      if (path.has(node)) throw new Flaw(`is broken: nodes[${node}] is its own ancestor`);
      path.add(node);
      node = parents.get(node);
    }
    let depth = depths.get(node ?? -1) ?? 0;
    for (const below of [...path].reverse()) depths.set(below, ++depth);
    if (depth > MOST_DEPTH) throw new Flaw(`is too deep: more than ${MOST_DEPTH} nodes in nodes`);
  }
}

function checkTriangles(
  shown: readonly number[],
  nodes: readonly Node[],
  { meshes, accessors }: Pick<Lists, "meshes" | "accessors">,
): void {
  const countOf = (accessor: number | undefined) => accessors[accessor ?? -1]?.count ?? 0;
  let triangles = 0;
  // Each part keeps only the vertices of its triangles: an accessor that many share is read once.
  const positions = new Set<number | undefined>();
  for (const index of shown) {
    const { mesh, instances } = nodes[index] ?? {};
    const copies = instances ? countOf(Object.values(instances)[0]) : 1;
    for (const primitive of meshes[mesh ?? -1]?.primitives ?? []) {
      triangles += primitive.triangles * copies;
      positions.add(primitive.attributes.POSITION);
    }
  }
  checkTriangleCount(triangles);
  const vertices = [...positions].reduce<number>((sum, accessor) => sum + countOf(accessor), 0);
  checkCount("vertices", vertices, MOST_VERTICES);
}

export function checkTriangleCount(triangles: number): void {
  checkCount("triangles", triangles, MOST_TRIANGLES);
}

function checkCount(what: string, count: number, most: number): void {
  if (count <= most) return;
  const million = (value: number) => `${+(value / 1e6).toPrecision(3)} million`;
  throw new Flaw(`has too many ${what}: ${million(count)}, where ${million(most)} are the limit`);
}
