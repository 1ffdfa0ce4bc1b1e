import { mkdirSync, writeFileSync } from "node:fs";
import { Logger, NodeIO } from "@gltf-transform/core";
import {
  ALL_EXTENSIONS,
  EXTMeshoptCompression,
  EXTTextureAVIF,
  EXTTextureWebP,
  KHRDracoMeshCompression,
  KHRTextureBasisu,
} from "@gltf-transform/extensions";
import { quantize, reorder } from "@gltf-transform/functions";
import { MeshoptDecoder, MeshoptEncoder } from "meshoptimizer";
import sharp from "sharp";
import { GlbBuilder } from "../../tools/models/glb-builder.mjs";

/**
 * Makes the models that the tests of any visitor's room load, one for each kind of file:
 *
 *     node tests/support/fixture-models.mjs
 *
 * All show the same sign: 2 x 1 m, upright at z = 0, facing +Z, its left half red, its right half
 * blue. The encoders of Draco (draco3d 1.5.7) and KTX2 (ktx2-encoder 0.6.0) are no dependencies of
 * ours; where they are not installed those files stay as they are.
 */

const FOLDER = new URL("../fixtures/models/", import.meta.url);
mkdirSync(FOLDER, { recursive: true });

const write = (name, bytes) => {
  writeFileSync(new URL(name, FOLDER), bytes);
  console.log(`${name}: ${bytes.length} bytes`);
};

const POSITIONS = [0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0];
const NORMALS = [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1];
const TANGENTS = [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1];
const UVS = [0, 1, 1, 1, 1, 0, 0, 0];
const CORNERS = [0, 1, 2, 0, 2, 3];
const floats = (values) => Float32Array.from(values);

/** The sign's picture: left red, right blue. */
function raw(size = 8) {
  const pixels = Buffer.alloc(size * size * 3);
  for (let i = 0; i < size * size; i++) pixels[i * 3 + (i % size < size / 2 ? 0 : 2)] = 255;
  return sharp(pixels, { raw: { width: size, height: size, channels: 3 } });
}
const PNG = await raw().png().toBuffer();
const GREY_PNG = await sharp({
  create: { width: 4, height: 4, channels: 3, background: { r: 128, g: 128, b: 128 } },
})
  .png()
  .toBuffer();

function signMesh(builder, { attributes = {}, material, ...primitive } = {}) {
  return builder.add("meshes", {
    name: "sign",
    primitives: [
      {
        attributes: {
          POSITION: builder.accessor(floats(POSITIONS), 3),
          NORMAL: builder.accessor(floats(NORMALS), 3),
          TANGENT: builder.accessor(floats(TANGENTS), 4),
          TEXCOORD_0: builder.accessor(floats(UVS), 2),
          ...attributes,
        },
        indices: builder.accessor(Uint16Array.from(CORNERS), 1),
        material,
        ...primitive,
      },
    ],
  });
}

/** A texture of the builder's file and the number that materials know it by. */
function texture(builder, bytes, mimeType = "image/png") {
  const source = builder.add("images", { bufferView: builder.view(bytes), mimeType });
  return builder.add("textures", { source });
}

function paint(builder, textureInfo = {}) {
  return builder.add("materials", {
    name: "paint",
    pbrMetallicRoughness: {
      baseColorTexture: { index: texture(builder, PNG), ...textureInfo },
      metallicFactor: 0,
      roughnessFactor: 0.75,
    },
  });
}

function sign() {
  const builder = new GlbBuilder();
  builder.root({ name: "sign", mesh: signMesh(builder, { material: paint(builder) }) });
  builder.root({
    name: "spawn",
    translation: [1, 0, 2],
    rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
  });
  return builder;
}

function separate() {
  const builder = sign();
  const binary = builder.binary();
  const json = builder.json;
  const { byteOffset } = json.bufferViews.splice(0, 1)[0]; // the picture, which comes first
  for (const accessor of json.accessors) accessor.bufferView--;
  const withUris = (buffer, image) => ({
    ...json,
    buffers: [{ uri: buffer, byteLength: binary.length }],
    images: [{ uri: image }],
  });
  if (byteOffset !== 0) throw new Error("The picture is not the first thing in the file.");
  write("separate.gltf", Buffer.from(JSON.stringify(withUris("separate.bin", "separate.png"))));
  write("separate.bin", binary);
  write("separate.png", PNG);
  const data = (type, bytes) => `data:${type};base64,${bytes.toString("base64")}`;
  const embedded = withUris(data("application/octet-stream", binary), data("image/png", PNG));
  write("embedded.gltf", Buffer.from(JSON.stringify(embedded)));
}

function sparse() {
  const builder = new GlbBuilder();
  const mesh = signMesh(builder, { material: paint(builder) });
  const { attributes } = builder.json.meshes[mesh].primitives[0];
  // All at z = 5 and the origin, if its changes are not made.
  const moved = POSITIONS.map((value, i) => (i % 3 === 2 ? 5 : value));
  const changes = (values) => ({
    count: 4,
    indices: { bufferView: builder.view(Buffer.from([0, 1, 2, 3])), componentType: 5121 },
    values: { bufferView: builder.view(Buffer.from(floats(values).buffer)) },
  });
  attributes.POSITION = builder.accessor(floats(moved), 3);
  builder.json.accessors[attributes.POSITION].sparse = { ...changes(POSITIONS) };
  const uv = builder.json.accessors[attributes.TEXCOORD_0];
  delete uv.bufferView;
  uv.sparse = changes(UVS);
  builder.root({ mesh });
  return builder;
}

function colors() {
  const builder = new GlbBuilder();
  const kinds = {
    "rgb bytes": [Uint8Array, 3, 255, true],
    "rgba shorts": [Uint16Array, 4, 65535, true],
    "rgb floats": [Float32Array, 3, 1, false],
    "forgotten flag": [Uint8Array, 4, 255, false],
  };
  for (const [name, [Type, size, whole, normalized]] of Object.entries(kinds)) {
    const rgba = [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0.2, 0.4, 0.6, 0.8];
    const values = rgba.filter((_, i) => i % 4 < size).map((value) => value * whole);
    const COLOR_0 = builder.accessor(Type.from(values.map((v) => v)), size, { normalized });
    builder.root({ name, mesh: signMesh(builder, { attributes: { COLOR_0 } }) });
  }
  return builder;
}

function uvSets() {
  const builder = new GlbBuilder();
  const material = builder.add("materials", {
    name: "two sets",
    pbrMetallicRoughness: { baseColorTexture: { index: texture(builder, PNG), texCoord: 1 } },
    occlusionTexture: { index: texture(builder, GREY_PNG), texCoord: 0, strength: 0.5 },
    normalTexture: { index: 1, texCoord: 0 },
  });
  const TEXCOORD_1 = builder.accessor(floats(UVS.map((value) => value / 2 + 0.25)), 2);
  builder.root({ mesh: signMesh(builder, { material, attributes: { TEXCOORD_1 } }) });
  return builder;
}

function textureTransform() {
  const builder = new GlbBuilder();
  const KHR_texture_transform = { offset: [0.25, 0.5], rotation: Math.PI / 2, scale: [2, 3] };
  const material = paint(builder, { extensions: { KHR_texture_transform } });
  builder.use("KHR_texture_transform");
  builder.root({ mesh: signMesh(builder, { material }) });
  return builder;
}

function transforms() {
  const builder = new GlbBuilder();
  const mesh = signMesh(builder, { material: paint(builder) });
  const child = builder.add("nodes", { name: "mirrored", mesh, scale: [-1, 1, 1] });
  // A quarter turn to the left: the sign looks along +X, and z counts down along it.
  builder.root({
    name: "turned",
    rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
    translation: [10, 0, 0],
    scale: [3, 2, 1],
    children: [child],
  });
  const slope = builder.add("meshes", {
    primitives: [
      {
        attributes: {
          POSITION: builder.accessor(floats([0, 0, 0, 1, -1, 0, 0, 0, -1]), 3),
          NORMAL: builder.accessor(
            floats([0, 1, 2].flatMap(() => [Math.SQRT1_2, Math.SQRT1_2, 0])),
            3,
          ),
        },
      },
    ],
  });
  builder.root({ name: "slope", mesh: slope, scale: [2, 1, 1] });
  return builder;
}

function instances() {
  const builder = new GlbBuilder();
  const TRANSLATION = builder.accessor(floats([0, 0, 0, 5, 0, 0, 0, 0, 7]), 3);
  const SCALE = builder.accessor(floats([1, 1, 1, 2, 2, 2, -1, 1, 1]), 3);
  builder.use("EXT_mesh_gpu_instancing");
  builder.root({
    name: "signs",
    translation: [0, 1, 0],
    mesh: signMesh(builder, { material: paint(builder) }),
    extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION, SCALE } } },
  });
  return builder;
}

function primitives() {
  const builder = new GlbBuilder();
  const corners = (order) =>
    builder.accessor(floats(order.flatMap((i) => POSITIONS.slice(i * 3, i * 3 + 3))), 3);
  const kinds = {
    strip: { mode: 5, attributes: { POSITION: corners([0, 1, 3, 2]) } },
    fan: { mode: 6, attributes: { POSITION: corners([0, 1, 2, 3]) } },
    loose: { attributes: { POSITION: corners(CORNERS) } },
    lines: { mode: 1, attributes: { POSITION: corners([0, 1]) } },
    points: { mode: 0, attributes: { POSITION: corners([0, 1]) } },
  };
  for (const [name, primitive] of Object.entries(kinds)) {
    builder.root({ name, mesh: builder.add("meshes", { primitives: [primitive] }) });
  }
  return builder;
}

/** Positions and corners, and nothing else: a bent sheet whose two halves share an edge. */
function bare() {
  const builder = new GlbBuilder();
  const positions = floats([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, -1, 0, 1, -1]);
  const mesh = builder.add("meshes", {
    primitives: [
      {
        attributes: { POSITION: builder.accessor(positions, 3) },
        indices: builder.accessor(Uint8Array.from([0, 1, 2, 0, 2, 3, 4, 0, 3, 4, 3, 5]), 1),
      },
    ],
  });
  builder.root({ mesh });
  return builder;
}

function posed() {
  const builder = new GlbBuilder();
  const joint = (translation, children) => builder.add("nodes", { translation, children });
  const hand = joint([0, 0, 3]);
  const arm = joint([0, 2, 0], [hand]);
  builder.json.scenes[0].nodes.push(arm);
  const inverse = floats([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  builder.add("skins", {
    joints: [arm, hand],
    inverseBindMatrices: builder.accessor(floats([...inverse, ...inverse]), 16),
  });
  // The lower corners hang on the arm, the upper ones half on the hand.
  const JOINTS_0 = builder.accessor(
    Uint8Array.from([0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]),
    4,
  );
  const WEIGHTS_0 = builder.accessor(
    floats([1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0]),
    4,
  );
  builder.root({
    name: "skinned",
    translation: [100, 0, 0], // of no account: its bones place it
    mesh: signMesh(builder, { attributes: { JOINTS_0, WEIGHTS_0 } }),
    skin: 0,
  });
  const target = builder.accessor(floats(POSITIONS.map((_, i) => (i % 3 === 0 ? 4 : 0))), 3);
  const mesh = signMesh(builder, { targets: [{ POSITION: target, TANGENT: target }] });
  builder.json.meshes[mesh].weights = [0.5];
  builder.root({ name: "morphed", mesh });
  return builder;
}

function scenes() {
  const builder = sign();
  builder.add("scenes", {
    nodes: [builder.add("nodes", { name: "other", mesh: 0, translation: [0, 3, 0] })],
  });
  builder.json.scene = 1;
  return builder;
}

function materials() {
  const builder = new GlbBuilder();
  const grey = texture(builder, GREY_PNG);
  const colour = texture(builder, PNG);
  const kinds = {
    glass: {
      alphaMode: "BLEND",
      pbrMetallicRoughness: { baseColorFactor: [0.5, 0.6, 0.7, 0.25], roughnessFactor: 0.1 },
      extensions: { KHR_materials_transmission: { transmissionFactor: 1 } },
    },
    leaf: { alphaMode: "MASK", alphaCutoff: 0.3, doubleSided: true },
    lamp: { emissiveFactor: [1, 1, 1], extensions: { KHR_materials_unlit: {} } },
    packed: {
      pbrMetallicRoughness: { metallicRoughnessTexture: { index: colour } },
      occlusionTexture: { index: colour, strength: 0.25 },
      normalTexture: { index: grey, scale: 0.5 },
    },
    apart: {
      pbrMetallicRoughness: { metallicRoughnessTexture: { index: colour } },
      occlusionTexture: { index: grey },
    },
    glossy: {
      extensions: {
        KHR_materials_pbrSpecularGlossiness: {
          diffuseFactor: [0.1, 0.2, 0.3, 1],
          glossinessFactor: 0.25,
        },
      },
    },
  };
  builder.use(
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_lights_punctual",
    "EXAMPLE_of_tomorrow",
  );
  builder.json.extensions = {
    KHR_lights_punctual: { lights: [{ type: "point", intensity: 100 }] },
  };
  builder.root({ name: "lamp light", extensions: { KHR_lights_punctual: { light: 0 } } });
  for (const [name, material] of Object.entries(kinds)) {
    const mesh = signMesh(builder, { material: builder.add("materials", { name, ...material }) });
    builder.root({ name, mesh });
  }
  return builder;
}

write("plain.glb", sign().glb());
separate();
write("sparse.glb", sparse().glb());
write("colors.glb", colors().glb());
write("uv-sets.glb", uvSets().glb());
write("texture-transform.glb", textureTransform().glb());
write("transforms.glb", transforms().glb());
write("instances.glb", instances().glb());
write("primitives.glb", primitives().glb());
write("bare.glb", bare().glb());
write("posed.glb", posed().glb());
write("scenes.glb", scenes().glb());
write("materials.glb", materials().glb());

const io = new NodeIO()
  .setLogger(new Logger(Logger.Verbosity.WARN))
  .registerExtensions(ALL_EXTENSIONS)
  .registerDependencies({ "meshopt.decoder": MeshoptDecoder, "meshopt.encoder": MeshoptEncoder });

/** The sign, changed by glTF Transform. */
async function changed(name, change) {
  const document = await io.readBinary(new Uint8Array(sign().glb()));
  await change(document);
  write(name, await io.writeBinary(document));
}

const repaint = (mimeType, bytes) => (document) => {
  const extensions = {
    "image/webp": EXTTextureWebP,
    "image/avif": EXTTextureAVIF,
    "image/ktx2": KHRTextureBasisu,
  };
  document.createExtension(extensions[mimeType]).setRequired(true);
  document.getRoot().listTextures()[0].setImage(new Uint8Array(bytes)).setMimeType(mimeType);
};

await MeshoptEncoder.ready;
await changed("quantized.glb", (document) => document.transform(quantize()));
await changed("meshopt.glb", async (document) => {
  await document.transform(reorder({ encoder: MeshoptEncoder }), quantize());
  document
    .createExtension(EXTMeshoptCompression)
    .setRequired(true)
    .setEncoderOptions({ method: EXTMeshoptCompression.EncoderMethod.FILTER });
});
await changed("webp.glb", repaint("image/webp", await raw().webp({ lossless: true }).toBuffer()));
await changed(
  "avif.glb",
  repaint(
    "image/avif",
    await raw(16).avif({ lossless: true, chromaSubsampling: "4:4:4" }).toBuffer(),
  ),
);

const optional = (name) =>
  import(name).catch(() => {
    console.log(`${name} is not installed; its files stay as they are.`);
    return null;
  });

const draco = await optional("draco3d");
if (draco) {
  const draco3d = draco.default;
  io.registerDependencies({ "draco3d.encoder": await draco3d.createEncoderModule() });
  await changed("draco.glb", (document) => {
    document.createExtension(KHRDracoMeshCompression).setRequired(true);
  });
}

const ktx2 = await optional("ktx2-encoder");
if (ktx2) {
  const imageDecoder = async (bytes) => {
    const { data, info } = await sharp(bytes)
      .ensureAlpha()
      .raw()
      .toBuffer({ resolveWithObject: true });
    return { data: new Uint8Array(data), width: info.width, height: info.height };
  };
  for (const [name, isUASTC] of [
    ["ktx2-etc1s.glb", false],
    ["ktx2-uastc.glb", true],
  ]) {
    const options = { isUASTC, needSupercompression: isUASTC, generateMipmap: true, imageDecoder };
    const bytes = await ktx2.encodeToKTX2(new Uint8Array(PNG), options);
    await changed(name, repaint("image/ktx2", bytes));
  }
}
