import { Box3, type Group, type Mesh, type Object3D, Vector3 } from "three";
import { Flaw } from "./asset-error.js";
import { checkTriangleCount } from "./gltf-document.js";
import type { Anchor, Box, Model, Part } from "./model.js";
import { DEFAULT_MATERIAL, type PlacedMaterial } from "./read-material.js";
import { readPart } from "./read-part.js";
import { readWicks } from "./read-wicks.js";

/** Names of the nodes that are read. */
const PLACES: ReadonlySet<unknown> = new Set(["spawn", "moon"]);

const LARGEST = 10_000; // metres
const SMALLEST = 0.001; // metres
/** Size of candles alone, metres, beyond which another unit was meant. */
const LARGEST_CANDLE = 10;
/** Distance up to which a room is drawn, metres: the camera's far plane. */
const SEEN = 60;

type SceneContent = Pick<Model, "parts" | "anchors" | "wicks" | "bounds">;

/**
 * The triangles of a scene and the places it names; sentences about what is wrong there are added.
 *
 * @param isCandle whether it is to be a candle alone
 */
export function readScene(
  scene: Group,
  materials: ReadonlyMap<string, PlacedMaterial>,
  warnings: Set<string>,
  isCandle: boolean,
): SceneContent {
  const parts: Part[] = [];
  const anchors = new Map<string, Anchor>();
  scene.traverse((node) => {
    if ("isMesh" in node) {
      const mesh = node as Mesh;
      const { name } = mesh.material as { readonly name: string };
      const part = readPart(mesh, nameOf(mesh), materials.get(name) ?? DEFAULT_MATERIAL);
      if (part) parts.push(part);
    } else if (PLACES.has(node.userData.name) && !anchors.has(nameOf(node)) && isPlace(node)) {
      anchors.set(nameOf(node), anchorAt(node));
    }
  });
  checkTriangleCount(parts.reduce((sum, { indices }) => sum + indices.length / 3, 0));
  const wicks = readWicks(scene, warnings);
  const bounds = boundsOf(parts);
  const content = { parts, anchors: Object.fromEntries(anchors), wicks, bounds };
  const size = Math.max(...bounds.max.map((most, axis) => most - (bounds.min[axis] ?? 0)));
  if (isCandle && size > LARGEST_CANDLE) {
    const [unit, scale] = size > 1000 ? ["millimetres", 0.001] : ["centimetres", 0.01];
    warnings.add(`A candle of ${size.toPrecision(3)} m is read as one in ${unit}.`);
    return scaled(content, scale);
  }
  if (!isCandle && size > SEEN) warnings.add(`What is more than ${SEEN} m away is not drawn.`);
  return content;
}

function scaled({ parts, anchors, wicks, bounds }: SceneContent, scale: number): SceneContent {
  const move = ([x, y, z]: Anchor["position"]) => [x * scale, y * scale, z * scale] as const;
  return {
    parts: parts.map((part) => ({ ...part, positions: part.positions.map((x) => x * scale) })),
    anchors,
    wicks: wicks.map((wick) => ({ ...wick, position: move(wick.position) })),
    bounds: { min: move(bounds.min), max: move(bounds.max) },
  };
}

/** The node's name as the file has it, which three keeps beside the one it makes unique. */
function nameOf(object: Object3D): string {
  const name: unknown = object.userData.name ?? object.parent?.userData.name;
  return typeof name === "string" ? name : object.name;
}

/** With no mesh at or below it, and no bone. */
function isPlace(node: Object3D): boolean {
  if ("isBone" in node) return false;
  let isEmpty = true;
  node.traverse((below) => {
    if (below.userData.isEmpty !== true) isEmpty = false;
  });
  return isEmpty;
}

function anchorAt({ matrixWorld }: Object3D): Anchor {
  const position = new Vector3().setFromMatrixPosition(matrixWorld);
  const forward = new Vector3().setFromMatrixColumn(matrixWorld, 2).negate();
  // Squares of huge and tiny numbers are none.
  forward.divideScalar(Math.max(...forward.toArray().map(Math.abs)));
  // That of a node that is not turned, for one of scale 0.
  if (!(forward.length() > 0)) forward.set(0, 0, -1);
  // Straight up or down it points nowhere on the floor.
  const isLevel = Math.hypot(forward.x, forward.z) > 1e-6 * forward.length();
  return {
    position: position.toArray(),
    yaw: isLevel ? Math.atan2(-forward.x, -forward.z) : 0,
    forward: forward.normalize().toArray(),
  };
}

function boundsOf(parts: readonly Part[]): Box {
  if (parts.length === 0) throw new Flaw("holds no geometry");
  const box = new Box3();
  for (const { positions } of parts) {
    const { min, max } = new Box3().setFromArray(positions);
    box.expandByPoint(min).expandByPoint(max);
  }
  const size = Math.max(...box.getSize(new Vector3()));
  const farthest = Math.max(...[...box.min, ...box.max].map(Math.abs));
  if (size > LARGEST) {
    throw new Flaw(`is ${(size / 1000).toPrecision(3)} km large; glTF counts in metres`);
  }
  if (farthest > LARGEST) {
    throw new Flaw(`stands ${(farthest / 1000).toPrecision(3)} km from its origin`);
  }
  if (size < SMALLEST) {
    throw new Flaw(`is ${(size * 1000).toPrecision(3)} mm large; glTF counts in metres`);
  }
  return { min: box.min.toArray(), max: box.max.toArray() };
}
