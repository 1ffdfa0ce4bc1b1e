import type { GltfDocument } from "./gltf-document.js";
import type { JsonEntry } from "./json-entry.js";
import { isGlossy, type Material, PLAIN_MATERIAL, type TextureImage } from "./model.js";
import { resized, type TextureImages } from "./texture-images.js";
import { type Placement, readTextureUse, type TextureUse, UNTURNED } from "./texture-placement.js";

export interface PlacedMaterial {
  readonly material: Material;
  readonly placement: Placement;
}

const MIRRORED_REPEAT = 33648;
const CLAMP_TO_EDGE = 33071;
const NEAREST = 9728;

/**
 * Material of a surface without one. glTF's default, a rough metal, is nearly black in the light of one flame; this
 * resembles plaster.
 */
export const DEFAULT_MATERIAL: PlacedMaterial = {
  material: PLAIN_MATERIAL,
  placement: UNTURNED,
};

/** Reads a material and its images; unsupported parts are added to the warnings. */
export async function readMaterial(
  document: GltfDocument,
  entry: JsonEntry,
  images: TextureImages,
  warnings: Set<string>,
): Promise<PlacedMaterial> {
  const name = entry.string("name") ?? "";
  const use = (of: JsonEntry | undefined, map: string) => {
    const found = readTextureUse(of?.entry(map), document.textures.length);
    for (const warning of found ? samplingWarnings(document, found.texture) : []) {
      warnings.add(warning);
    }
    return found;
  };
  let surface = readSurface(entry);
  const albedo = use(surface.entry, surface.albedo);
  const metallicRoughness = use(surface.roughnessEntry, "metallicRoughnessTexture");
  const normal = use(entry, "normalTexture");
  const occlusion = use(entry, "occlusionTexture");

  const placement = (albedo ?? normal ?? metallicRoughness)?.placement ?? UNTURNED;
  const isPlacedAlike = (map: TextureUse | null) =>
    map === null || JSON.stringify(map.placement) === JSON.stringify(placement);
  const pictureOf = (map: TextureUse | null, what: string) => {
    if (map === null) return null;
    if (isPlacedAlike(map)) return images.texture(map.texture);
    warnings.add(
      `The ${what} map of material "${name}" lies otherwise than its colour and is left out.`,
    );
    return null;
  };
  // An occlusion map apart is left out: shadows do its work.
  const isPacked =
    occlusion !== null &&
    metallicRoughness !== null &&
    images.areSame(occlusion.texture, metallicRoughness.texture) &&
    isPlacedAlike(occlusion);
  const [albedoPicture, normalPicture, packedPicture] = await Promise.all([
    pictureOf(albedo, "colour"),
    pictureOf(normal, "normal"),
    pictureOf(metallicRoughness, "roughness"),
  ]);
  // Of a factor alone, without the map that it multiplies, all would be metal.
  if (metallicRoughness && !packedPicture) surface = { ...surface, metallic: 0 };
  const alpha = readAlpha(entry);
  return {
    material: {
      name,
      baseColor: surface.baseColor,
      roughness: surface.roughness,
      metallic: surface.metallic,
      normalScale: normal?.amount ?? 1,
      occlusionStrength: isPacked ? clamp01(occlusion.amount) : 0,
      isDoubleSided: entry.boolean("doubleSided"),
      ...readDepth(entry, name),
      isGlossy: await isGlossySomewhere(surface, packedPicture),
      ...alpha,
      mapOpacity: await opacityOf(alpha, albedoPicture),
      albedo: albedoPicture,
      normal: normalPicture,
      occlusionRoughnessMetallic: packedPicture,
    },
    placement,
  };
}

const clamp01 = (value: number) => Math.min(1, Math.max(0, value));

function readSurface(entry: JsonEntry) {
  const glossy = entry.extension("KHR_materials_pbrSpecularGlossiness");
  const plain = entry.entry("pbrMetallicRoughness");
  const isUnlit = entry.extension("KHR_materials_unlit") !== undefined;
  // The factor is 1 where there is a map, which is not read.
  const glossiness = glossy?.has("specularGlossinessTexture") ? undefined : glossy;
  const factor = glossy?.numbers("diffuseFactor", 4) ?? plain?.numbers("baseColorFactor", 4);
  const [red = 1, green = 1, blue = 1, opacity = 1] = (factor ?? []).map(clamp01);
  return {
    entry: glossy ?? plain,
    roughnessEntry: glossiness || isUnlit ? undefined : plain,
    albedo: glossy ? "diffuseTexture" : "baseColorTexture",
    baseColor: [red, green, blue, opacity] as const,
    roughness: clamp01(
      glossiness
        ? 1 - (glossiness.number("glossinessFactor") ?? 1)
        : isUnlit
          ? 1
          : (plain?.number("roughnessFactor") ?? 1),
    ),
    metallic: glossy || isUnlit ? 0 : clamp01(plain?.number("metallicFactor") ?? 1),
  };
}

/** Subsurface scattering, or transmission: clear glass has a volume, too. */
function readDepth(entry: JsonEntry, name: string): Pick<Material, "isWax" | "transmission"> {
  const factor = entry.extension("KHR_materials_transmission")?.number("transmissionFactor") ?? 0;
  const transmission = clamp01(factor);
  const isDeep = ["KHR_materials_volume", "KHR_materials_diffuse_transmission"].some(
    (extension) => entry.extension(extension) !== undefined,
  );
  return { isWax: transmission === 0 && (isDeep || name.startsWith("wax")), transmission };
}

function readAlpha(entry: JsonEntry): Pick<Material, "alphaMode" | "alphaCutoff"> {
  const mode = entry.string("alphaMode");
  return {
    alphaMode: mode === "MASK" ? "mask" : mode === "BLEND" ? "blend" : "opaque",
    // Above 1 nothing is left: specification, section 3.9.4.
    alphaCutoff: Math.max(0, entry.number("alphaCutoff") ?? 0.5),
  };
}

/** What of a texture's sampler is not done: all repeat, and are filtered. */
function samplingWarnings(document: GltfDocument, texture: number): readonly string[] {
  const sampler = document.textures[texture]?.index("sampler", document.samplers.length);
  const entry = document.samplers[sampler ?? -1];
  const wraps = [entry?.whole("wrapS"), entry?.whole("wrapT")];
  return [
    ...(wraps.includes(MIRRORED_REPEAT)
      ? ["Textures that repeat in mirror images repeat plainly."]
      : []),
    ...(wraps.includes(CLAMP_TO_EDGE) ? ["Textures that end at their edges repeat."] : []),
    ...(entry?.whole("magFilter") === NEAREST ? ["Textures of hard texels are filtered."] : []),
  ];
}

/** Parts of a map along each of its sides, and texels of a smaller copy along those of a part. */
const PARTS = 8;
const TEXELS = 8;

/**
 * Whether a material mirrors what is around it. The means of its map's parts tell: what is smooth is larger than a spot,
 * and shading it costs the more.
 */
async function isGlossySomewhere(
  { roughness, metallic }: Pick<Material, "roughness" | "metallic">,
  map: TextureImage | null,
): Promise<boolean> {
  if (!map) return isGlossy(roughness, metallic);
  const [, greens, blues] = await meansOf(map);
  return greens.some((green, part) => isGlossy(roughness * green, metallic * (blues[part] ?? 0)));
}

async function opacityOf(
  { alphaMode }: Pick<Material, "alphaMode">,
  map: TextureImage | null,
): Promise<number> {
  if (!map || alphaMode === "opaque") return 1;
  const [, , , alphas] = await meansOf(map);
  if (alphaMode === "mask") return Math.max(...alphas);
  return alphas.reduce((sum, alpha) => sum + alpha, 0) / alphas.length;
}

/** Red, green, blue and alpha of the parts of a map, 0 to 1. */
type Means = readonly [number[], number[], number[], number[]];

/** Of maps that have been read, each after the one before: some browsers shrink images while the page waits. */
const known = new WeakMap<TextureImage, Promise<Means>>();
let reading: Promise<unknown> = Promise.resolve();

function meansOf(map: TextureImage): Promise<Means> {
  const before = known.get(map);
  if (before) return before;
  const means = reading.then(() => readMeans(map));
  known.set(map, means);
  reading = means.catch(() => {});
  return means;
}

async function readMeans(map: TextureImage): Promise<Means> {
  const size = PARTS * TEXELS;
  const copy = await resized(map, { resizeWidth: size, resizeHeight: size });
  const context = new OffscreenCanvas(size, size).getContext("2d", { willReadFrequently: true });
  context?.drawImage(copy, 0, 0);
  copy.close();
  const none = () => Array.from({ length: PARTS * PARTS }, () => 0);
  const means: Means = [none(), none(), none(), none()];
  const { data = [] } = context?.getImageData(0, 0, size, size) ?? {};
  for (const [i, value] of data.entries()) {
    const [x, y] = [(i >> 2) % size, Math.floor((i >> 2) / size)];
    const part = Math.floor(y / TEXELS) * PARTS + Math.floor(x / TEXELS);
    const mean = means[i & 3];
    if (mean) mean[part] = (mean[part] ?? 0) + value / (255 * TEXELS ** 2);
  }
  return means;
}
