import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { MeshoptSimplifier } from "meshoptimizer";
import { openGlb, packGlb } from "./glb-builder.mjs";

/**
 * The lower level of detail of our models: for each primitive the indices of fewer triangles of the same
 * vertices, in `extras.reducedIndices`, so that a reader who knows nothing of it sees nothing of it. Low draws
 * them while the camera moves. cabin.mjs ends with this; by itself it makes the levels in public/models/ anew:
 *
 *     node tools/models/reduce.mjs
 */

/** How far a surface may move, metres: the room is some metres away, the candle in the hand. */
const ERRORS = { "cabin.glb": 0.006, "chamberstick.glb": 0.0008 };
/** The same of the wax in the hand, whose outline is straight: with more, it has dents. */
const HELD_WAX_ERROR = 0.0002;
const WAX = ["wax", "pool", "wick"];
/** Both sides of what is thin keep apart; candles are seen from near. */
const THIN_ERRORS = new Map([
  ...["brass", "pewter", "iron", "linen", "paper", "leather", "cloth-blue"].map((name) => [
    name,
    0.0015,
  ]),
  ...WAX.map((name) => [name, 0.0008]),
]);
/**
 * What a normal of length 1 and the edge of a picture weigh against a metre: at bevels and seams vertices may
 * take each other's, which shows where a floor's planks end unless it costs something.
 */
const WEIGHTS = { normal: 0.25, uv: 0.5 };

await MeshoptSimplifier.ready;

/** The file with a lower level for each primitive, in place of any that it has. */
export function withLowerLevels(file, glb) {
  const { json, binary } = withoutLowerLevels(glb);
  const chunks = [binary];
  let { length } = binary;
  for (const primitive of json.meshes.flatMap(({ primitives }) => primitives)) {
    const { name } = json.materials[primitive.material];
    const isHeldWax = file === "chamberstick.glb" && WAX.includes(name);
    const thin = isHeldWax ? HELD_WAX_ERROR : (THIN_ERRORS.get(name) ?? Number.POSITIVE_INFINITY);
    const error = Math.min(ERRORS[file], thin);
    const reduced = Uint16Array.from(reducedTriangles({ json, binary }, primitive, error));
    const byteLength = reduced.byteLength;
    const view = { buffer: 0, byteOffset: length, byteLength, target: 34963 };
    const bufferView = json.bufferViews.push(view) - 1;
    const accessor = { type: "SCALAR", componentType: 5123, count: reduced.length, bufferView };
    primitive.extras = { reducedIndices: json.accessors.push(accessor) - 1 };
    const bytes = Buffer.alloc(Math.ceil(byteLength / 4) * 4);
    bytes.set(Buffer.from(reduced.buffer));
    chunks.push(bytes);
    length += bytes.length;
    const before = json.accessors[primitive.indices].count;
    console.log(`  ${name}: ${before / 3} -> ${reduced.length / 3} triangles`);
  }
  json.buffers[0].byteLength = length;
  return { json, binary: Buffer.concat(chunks) };
}

/** What `withLowerLevels` added stands at the end of each list, and of the bytes. */
function withoutLowerLevels({ json, binary }) {
  const [{ extras }] = json.meshes[0].primitives;
  if (extras?.reducedIndices === undefined) return { json, binary };
  const { bufferView } = json.accessors[extras.reducedIndices];
  const { byteOffset } = json.bufferViews[bufferView];
  json.accessors.length = extras.reducedIndices;
  json.bufferViews.length = bufferView;
  return { json, binary: binary.subarray(0, byteOffset) };
}

function reducedTriangles(glb, { attributes, indices }, error) {
  const { POSITION, NORMAL, TEXCOORD_0 } = attributes;
  const read = (accessor, Type, size) => numbersOf(glb, accessor, Type, size);
  const positions = read(POSITION, Float32Array, 3);
  const normals = read(NORMAL, Float32Array, 3);
  const uvs = read(TEXCOORD_0, Float32Array, 2);
  const looks = new Float32Array((positions.length / 3) * 5);
  for (let i = 0; i < looks.length / 5; i++) {
    looks.set(normals.subarray(3 * i, 3 * i + 3), 5 * i);
    looks.set(uvs.subarray(2 * i, 2 * i + 2), 5 * i + 3);
  }
  const { normal, uv } = WEIGHTS;
  const [reduced] = MeshoptSimplifier.simplifyWithAttributes(
    Uint32Array.from(read(indices, Uint16Array, 1)),
    positions,
    3,
    looks,
    5,
    [normal, normal, normal, uv, uv],
    null,
    0,
    error,
    ["ErrorAbsolute", "Permissive"],
  );
  return reduced;
}

/** The numbers of an accessor, packed, so many to an element. */
function numbersOf({ json, binary }, index, Type, size) {
  const { bufferView, byteOffset = 0, count } = json.accessors[index];
  const begin = (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
  // Copied: a view of floats begins at a multiple of its size.
  return new Type(Uint8Array.from(binary.subarray(begin)).buffer, 0, size * count);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const file of Object.keys(ERRORS)) {
    const path = new URL(`../../public/models/${file}`, import.meta.url);
    const { json, binary } = withLowerLevels(file, openGlb(readFileSync(path)));
    writeFileSync(path, packGlb(json, binary));
  }
}
