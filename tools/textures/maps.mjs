import { clamp } from "./noise.mjs";
import { srgbFromLinear } from "./pigment.mjs";
import { blurred } from "./surface.mjs";

/**
 * Unit normals of a periodic height field as RGB. Green grows where the surface faces up in the
 * picture, as glTF 2.0 has it (+Y up, the top row being v = 0).
 */
function normalMap({ resolution: size, texelSize, height }) {
  const pixels = new Uint8Array(3 * size * size);
  for (let row = 0; row < size; row++) {
    const above = ((row + size - 1) % size) * size;
    const below = ((row + 1) % size) * size;
    for (let column = 0; column < size; column++) {
      const left = (column + size - 1) % size;
      const right = (column + 1) % size;
      const slopeX = (height[row * size + right] - height[row * size + left]) / (2 * texelSize);
      const slopeDown = (height[below + column] - height[above + column]) / (2 * texelSize);
      const length = Math.hypot(slopeX, slopeDown, 1);
      const i = 3 * (row * size + column);
      pixels[i] = Math.round(127.5 - (127.5 * slopeX) / length);
      pixels[i + 1] = Math.round(127.5 + (127.5 * slopeDown) / length);
      pixels[i + 2] = Math.round(127.5 + 127.5 / length);
    }
  }
  return pixels;
}

const BEARINGS = 8;
const REACH = 40; // mm: wider hollows than this are the geometry's business

/**
 * The share of a uniform sky each point sees: cos² of the horizon, averaged over eight bearings
 * (Bavoil and Sainz 2008, "Image-space horizon-based ambient occlusion"), the horizon measured from
 * the local tangent plane so that a mere slope is not a shadow.
 */
function ambientOcclusion({ resolution: size, texelSize, height }) {
  const smooth = blurred(height, size, 3 / texelSize);
  const rays = [];
  for (let bearing = 0; bearing < BEARINGS; bearing++) {
    const angle = (2 * Math.PI * (bearing + 0.5)) / BEARINGS;
    const steps = [];
    for (let distance = texelSize; distance <= REACH; distance *= 1.5) {
      const dx = Math.round((Math.cos(angle) * distance) / texelSize);
      const dy = Math.round((Math.sin(angle) * distance) / texelSize);
      if (dx || dy) steps.push({ dx, dy, length: Math.hypot(dx, dy) * texelSize });
    }
    rays.push(steps);
  }
  const openness = new Float32Array(size * size);
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const i = row * size + column;
      const slopeX =
        (smooth[row * size + ((column + 1) % size)] -
          smooth[row * size + ((column + size - 1) % size)]) /
        2;
      const slopeY =
        (smooth[((row + 1) % size) * size + column] -
          smooth[((row + size - 1) % size) * size + column]) /
        2;
      let occluded = 0;
      for (const steps of rays) {
        let horizon = 0;
        for (const { dx, dy, length } of steps) {
          const there = ((row + dy + size) % size) * size + ((column + dx + size) % size);
          const rise = height[there] - height[i] - slopeX * dx - slopeY * dy;
          if (rise > horizon * length) horizon = rise / length;
        }
        occluded += (horizon * horizon) / (1 + horizon * horizon);
      }
      openness[i] = 1 - occluded / BEARINGS;
    }
  }
  return openness;
}

/** A surface as the three 8-bit RGB pictures glTF asks for: albedo, normal, occlusion-roughness-metal. */
export function mapsFromSurface(surface) {
  const { resolution, albedo, roughness, metallic } = surface;
  const openness = ambientOcclusion(surface);
  const albedoPixels = new Uint8Array(albedo.length);
  const ormPixels = new Uint8Array(albedo.length);
  for (let i = 0; i < albedo.length; i++) {
    albedoPixels[i] = Math.round(255 * srgbFromLinear(clamp(albedo[i])));
  }
  for (let i = 0; i < roughness.length; i++) {
    ormPixels[3 * i] = Math.round(255 * openness[i]);
    ormPixels[3 * i + 1] = Math.round(255 * roughness[i]);
    ormPixels[3 * i + 2] = Math.round(255 * metallic[i]);
  }
  return { resolution, albedo: albedoPixels, normal: normalMap(surface), orm: ormPixels };
}
