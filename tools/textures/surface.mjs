import { clamp } from "./noise.mjs";
import { glaze } from "./pigment.mjs";

/**
 * A square of surface that repeats both ways: linear albedo, height, roughness, metalness, one value a
 * texel, top row first. Inside tools/textures lengths are millimetres, the scale of a trowel mark;
 * only a material's `tile` is in metres.
 *
 * `sample(x, y, texel)` fills in one point; what it leaves out is no metal. It runs `density`² times a texel and the results are
 * averaged, so that a crack thinner than a texel darkens it instead of flickering.
 */
export function synthesizeSurface({ resolution, tile, density = 2 }, sample) {
  const count = resolution * resolution;
  const surface = {
    resolution,
    texelSize: (tile * 1000) / resolution,
    albedo: new Float32Array(3 * count),
    height: new Float32Array(count),
    roughness: new Float32Array(count),
    metallic: new Float32Array(count),
  };
  const texel = { albedo: [0, 0, 0], height: 0, roughness: 1, metallic: 0 };
  const step = surface.texelSize / density;
  const share = 1 / (density * density);
  for (let row = 0; row < resolution; row++) {
    for (let column = 0; column < resolution; column++) {
      const i = row * resolution + column;
      for (let k = 0; k < density * density; k++) {
        const x = column * surface.texelSize + ((k % density) + 0.5) * step;
        const y = row * surface.texelSize + (Math.floor(k / density) + 0.5) * step;
        texel.metallic = 0;
        sample(x, y, texel);
        for (let c = 0; c < 3; c++) surface.albedo[3 * i + c] += share * clamp(texel.albedo[c]);
        surface.height[i] += share * texel.height;
        surface.roughness[i] += share * clamp(texel.roughness, 0.04, 1);
        surface.metallic[i] += share * texel.metallic;
      }
    }
  }
  return surface;
}

function blurRows(source, target, size, radius) {
  const weight = 1 / (2 * radius + 1);
  for (let row = 0; row < size; row++) {
    const start = row * size;
    let sum = 0;
    for (let k = -radius; k <= radius; k++) sum += source[start + ((k + 4 * size) % size)];
    for (let column = 0; column < size; column++) {
      // Transposed on writing: two calls blur both ways.
      target[column * size + row] = sum * weight;
      sum += source[start + ((column + radius + 1) % size)];
      sum -= source[start + ((column - radius + 4 * size) % size)];
    }
  }
}

/** A periodic square field averaged over about `radius` texels: two box blurs, a tent. */
export function blurred(field, size, radius) {
  const texels = Math.max(1, Math.round(radius));
  let source = field;
  for (let pass = 0; pass < 2; pass++) {
    const across = new Float32Array(field.length);
    const down = new Float32Array(field.length);
    blurRows(source, across, size, texels);
    blurRows(across, down, size, texels);
    source = down;
  }
  return source;
}

/**
 * Lets dirt gather where the surface lies lower than its surroundings and rubs the ridges clean:
 * within `radius` mm, a hollow of `depth` mm takes the whole `dirt` filter and `roughness` more.
 */
export function weather(surface, { radius, depth, dirt, polish = 0.3, roughness = 0 }) {
  const { resolution, texelSize, albedo, height } = surface;
  const level = blurred(height, resolution, radius / texelSize);
  const color = [0, 0, 0];
  for (let i = 0; i < height.length; i++) {
    const hollow = clamp((level[i] - height[i]) / depth, -polish, 1);
    for (let c = 0; c < 3; c++) color[c] = albedo[3 * i + c];
    glaze(color, dirt, hollow);
    for (let c = 0; c < 3; c++) albedo[3 * i + c] = color[c];
    surface.roughness[i] = clamp(surface.roughness[i] + roughness * hollow, 0.04, 1);
  }
  return surface;
}
