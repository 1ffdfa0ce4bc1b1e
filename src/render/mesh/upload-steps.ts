import type { Model } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import { groupTriangles } from "./clusters.js";
import { imagesOf, shareTexture, textureKey, uploadPart } from "./mesh.js";

/**
 * Uploads the next image of a model, or makes its mipmaps.
 *
 * @returns whether all of them are there
 */
export function uploadNextImage(gpu: Gpu, { parts }: Model): boolean {
  for (const { material } of parts) {
    for (const mapped of Object.values(imagesOf(material))) {
      if (!mapped.source) continue;
      const isThere = gpu.isShared(textureKey(gpu, mapped));
      const texture = shareTexture(gpu, mapped, mapped.source);
      if (isThere && !texture.needsMipmaps) continue;
      if (isThere) texture.updateMipmaps();
      return false;
    }
  }
  return true;
}

/** Uploads the next part of a model, whose images are there. Returns whether all parts are there. */
export function uploadNextPart(gpu: Gpu, { parts }: Model): boolean {
  const next = parts.find((part) => !gpu.isShared(part));
  if (next) uploadPart(gpu, next, groupTriangles);
  return !next;
}
