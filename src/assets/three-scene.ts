import type { Group, Mesh, Object3D } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { Flaw } from "./asset-error.js";
import type { ReadView } from "./buffer-bytes.js";
import { type Decoders, failure } from "./decoders.js";
import { denseBytes, floatBytes, MOST_BYTES } from "./gltf-accessors.js";
import type { GltfDocument, Node } from "./gltf-document.js";
import type { Primitive } from "./gltf-meshes.js";

const DRACO = "KHR_draco_mesh_compression";
const INSTANCING = "EXT_mesh_gpu_instancing";

/**
 * Builds the scene's geometry by three's `GLTFLoader`. It is given nothing else (no textures, no animations), and
 * is given each accessor as a buffer view of its own. A mesh's material is named by its index, a node's `userData` has
 * its `order` in the file, its `matrix`, and says whether it has no mesh (`isEmpty`), and a geometry's
 * `userData.reducedIndices` are those of its lower level of detail.
 */
export async function buildScene(
  document: GltfDocument,
  readView: ReadView,
  decoders: Decoders,
): Promise<Group> {
  const loader = new GLTFLoader();
  const isDraco = document.meshes.some(({ primitives }) => primitives.some(({ draco }) => draco));
  if (isDraco) loader.setDRACOLoader(await decoders.draco());
  let bytes = 0;
  const rawViews = document.views.length;
  const loadBufferView = async (index: number): Promise<ArrayBuffer> => {
    const accessor = document.accessors[index - rawViews];
    if (!accessor) return (await readView(index)).slice().buffer;
    bytes += floatBytes(accessor);
    if (bytes > MOST_BYTES) throw new Flaw(`has geometry of more than ${MOST_BYTES / 1e6} MB`);
    return (await denseBytes(accessor, document.views, readView)).buffer;
  };
  // Three's instances have no weights of morph targets.
  const weightsOf = ({ userData, parent }: Object3D) => {
    const node = document.nodes[userData.order ?? parent?.userData.order];
    return node?.weights ?? document.meshes[node?.mesh ?? -1]?.weights ?? [];
  };
  loader.register((parser) => ({
    name: "checked views",
    loadBufferView,
    afterRoot: async ({ scene }) => {
      const meshes: Mesh[] = [];
      scene.traverse((node) => {
        if ("isMesh" in node) meshes.push(node as Mesh);
        const { matrix } = node.userData;
        if (!matrix) return;
        // As it is: three would show one of scale 0 at full size, and one that shears without.
        const [a, b, c, , d, e, f, , g, h, i, , x, y, z] = matrix;
        node.matrix.set(a, d, g, x, b, e, h, y, c, f, i, z, 0, 0, 0, 1);
        node.matrixAutoUpdate = false;
      });
      for (const mesh of meshes) {
        if ("isInstancedMesh" in mesh) mesh.morphTargetInfluences = weightsOf(mesh);
        const { userData } = mesh.geometry;
        if (typeof userData.reducedIndices !== "number") continue;
        const { array } = await parser.getDependency("accessor", userData.reducedIndices);
        userData.reducedIndices = array;
      }
    },
  }));
  // `parseAsync` accepts a parsed document, too.
  const parsing = loader.parseAsync(gltfFor(document, isDraco) as never, "");
  const { scene } = await parsing.catch((cause: unknown) => {
    throw isDraco ? failure("holds geometry that cannot be decoded", cause) : cause;
  });
  scene.updateMatrixWorld(true);
  return scene as Group;
}

function gltfFor(document: GltfDocument, isDraco: boolean) {
  const { nodes, meshes, skins, accessors, views, materials, roots } = document;
  const posed = posedMeshes(document);
  return {
    asset: { version: "2.0" },
    extensionsUsed: isDraco ? [DRACO] : [],
    scene: 0,
    scenes: [{ nodes: roots }],
    nodes: nodes.map((node, order) => nodeFor(node, order, posed)),
    meshes: meshes.map(({ name, primitives, weights }, index) => ({
      name,
      primitives: primitives.map((primitive) =>
        primitiveFor(primitive, posed.has(index) ? accessors.length : 0),
      ),
      weights: posed.has(index) ? weights : undefined,
    })),
    skins,
    // Again without views, as zeros.
    accessors: [...accessors, ...accessors].map(
      ({ componentType, type, count, isNormalized }, index) => ({
        bufferView: index < accessors.length ? views.length + index : undefined,
        componentType,
        type,
        count,
        normalized: isNormalized,
        // The loader warns where they are missing. They are not used.
        min: [0, 0, 0],
        max: [0, 0, 0],
      }),
    ),
    bufferViews: [...views, ...accessors].map(() => ({})),
    materials: materials.map((_, index) => ({ name: String(index) })),
  };
}

function nodeFor(
  { isEmpty, isMisplaced, wickDiameter, instances, matrix, ...node }: Node,
  order: number,
  posed: ReadonlySet<number>,
) {
  return {
    ...node,
    name: node.name === "" ? undefined : node.name,
    weights: node.mesh !== undefined && posed.has(node.mesh) ? node.weights : undefined,
    extras: { order, isEmpty, isMisplaced, wickDiameter, matrix },
    extensions: instances && { [INSTANCING]: { attributes: instances } },
  };
}

/** Meshes that morph targets deform in the rest pose; the targets of the others need not be read. */
function posedMeshes({ meshes, nodes }: GltfDocument): ReadonlySet<number> {
  const isPose = (weights: readonly number[] = []) => weights.some((weight) => weight !== 0);
  const posedByNode = new Set(
    nodes.map(({ mesh, weights }) => (isPose(weights) ? mesh : undefined)),
  );
  const posed = meshes.flatMap(({ primitives, weights }, index) => {
    const isMorphed = primitives.every(({ targets }) => targets.length > 0);
    return isMorphed && (isPose(weights) || posedByNode.has(index)) ? [index] : [];
  });
  return new Set(posed);
}

/** @param zeros from an accessor to one of zeros; 0 where morph targets are not read */
function primitiveFor(primitive: Primitive, zeros: number) {
  const { attributes, indices, reducedIndices, mode, material, targets, draco } = primitive;
  // Three takes the base for what a target lacks.
  const morphed = ["POSITION", "NORMAL"].filter((name) => name in attributes);
  const targetFor = (target: Record<string, number>) =>
    Object.fromEntries(
      morphed.map((name) => [name, target[name] ?? (attributes[name] ?? 0) + zeros]),
    );
  return {
    attributes,
    indices,
    mode,
    material,
    targets: zeros > 0 ? targets.map(targetFor) : undefined,
    extras: { reducedIndices },
    extensions: draco && {
      [DRACO]: {
        bufferView: draco.view,
        attributes: Object.fromEntries(
          Object.entries(draco.attributes).filter(([name]) => name in attributes),
        ),
      },
    },
  };
}
