import type { GltfDocument } from "./gltf-document.js";

/** Extensions that are supported, or change nothing that is drawn. */
const SUPPORTED = new Set([
  "EXT_mesh_gpu_instancing",
  "EXT_meshopt_compression",
  "EXT_texture_avif",
  "EXT_texture_webp",
  "KHR_draco_mesh_compression",
  "KHR_mesh_quantization",
  "KHR_meshopt_compression",
  "KHR_texture_basisu",
  "KHR_texture_transform",
  "KHR_xmp_json_ld",
]);

/** The same, of a candle alone. */
const SUPPORTED_BY_CANDLES = new Set([
  "KHR_materials_diffuse_transmission",
  "KHR_materials_ior",
  "KHR_materials_transmission",
  "KHR_materials_volume",
]);

/** Effects of extensions that are not. */
const DEGRADED: Readonly<Record<string, string>> = {
  KHR_animation_pointer: "nothing moves",
  KHR_lights_punctual: "its lights stay out, the flame is the only one",
  KHR_materials_anisotropy: "highlights are round",
  KHR_materials_clearcoat: "surfaces are drawn without their coat",
  KHR_materials_diffuse_roughness: "matt surfaces are Lambert's",
  KHR_materials_dispersion: "glass does not split colours",
  KHR_materials_emissive_strength: "nothing glows but the flame",
  KHR_materials_ior: "everything reflects like glass, 4 %",
  KHR_materials_iridescence: "surfaces do not shimmer",
  KHR_materials_pbrSpecularGlossiness:
    "diffuse colour is kept, and glossiness that has no map, specular is not",
  KHR_materials_sheen: "cloth is drawn without its sheen",
  KHR_materials_specular: "everything reflects like glass, 4 %",
  KHR_materials_transmission: "what should be clear is as opaque as its alpha says",
  KHR_materials_unlit: "unlit surfaces are lit like all others",
  KHR_materials_variants: "the first variant is shown",
  KHR_materials_volume: "bodies are hollow",
};

/** Sentences about features of the file that are not supported. */
export function readWarnings(document: GltfDocument, isCandle: boolean): string[] {
  const warnings = document.extensionsUsed
    .filter((name) => !SUPPORTED.has(name) && !(isCandle && SUPPORTED_BY_CANDLES.has(name)))
    .map((name) => `${name} is not supported: ${DEGRADED[name] ?? "it is ignored"}.`);
  const { nodes, meshes, sceneCount, hasAnimations, materials } = document;
  if (sceneCount > 1) warnings.push(`Of its ${sceneCount} scenes one is shown.`);
  if (meshes.some(({ hasLines }) => hasLines)) warnings.push("Lines and points are not drawn.");
  if (hasAnimations) warnings.push("Animations are not played.");
  if (nodes.some(({ skin }) => skin !== undefined)) {
    warnings.push("Meshes with bones stand in their rest pose.");
  }
  if (materials.some((material) => material.has("emissiveTexture") || glows(material))) {
    warnings.push("Materials that glow do not: the flame is the only light.");
  }
  return warnings;
}

const glows = (material: GltfDocument["materials"][number]) =>
  (material.numbers("emissiveFactor") ?? []).some((value) => value > 0);
