/** Reflectances: linear Rec. 709 triples, mixed in place so that a texel costs no allocation. */

export function srgbFromLinear(x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}

function linearFromSrgb(x) {
  return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
}

/** A reflectance from the `0xrrggbb` an eyedropper would read. */
export function pigment(srgb) {
  return [16, 8, 0].map((shift) => linearFromSrgb(((srgb >> shift) & 255) / 255));
}

export function set(target, source) {
  target[0] = source[0];
  target[1] = source[1];
  target[2] = source[2];
}

/** Lays `source` over `target` at `coverage` 0..1. */
export function cover(target, source, coverage) {
  target[0] += (source[0] - target[0]) * coverage;
  target[1] += (source[1] - target[1]) * coverage;
  target[2] += (source[2] - target[2]) * coverage;
}

/** Darkens or lightens all three alike. */
export function scale(target, factor) {
  target[0] *= factor;
  target[1] *= factor;
  target[2] *= factor;
}

/** Multiplies by a filter, thinned towards none at `strength` zero. */
export function glaze(target, filter, strength) {
  target[0] *= 1 + (filter[0] - 1) * strength;
  target[1] *= 1 + (filter[1] - 1) * strength;
  target[2] *= 1 + (filter[2] - 1) * strength;
}
