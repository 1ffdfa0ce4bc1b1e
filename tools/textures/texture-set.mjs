import { mapsFromSurface } from "./maps.mjs";
import { materialNamed } from "./materials.mjs";
import { synthesizeSurface, weather } from "./surface.mjs";

/**
 * One texture set, from its seed alone: `{ resolution, albedo, normal, orm }`, RGB bytes, top row
 * first. At less than its own size a set has the same features, only fewer texels.
 */
export function textureSet(name, resolution) {
  const { size, tile, seed, sampler, weathering } = materialNamed(name);
  const texels = resolution ?? size;
  const surface = synthesizeSurface({ resolution: texels, tile }, sampler(seed, texels));
  return mapsFromSurface(weathering ? weather(surface, weathering) : surface);
}
