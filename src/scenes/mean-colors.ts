import type { Model, Part } from "../assets/model.js";
import { crossOf, verticesOf } from "../render/mesh/triangles.js";

/** Deviation of a vertex colour from the mean that is visible, linear. */
const VISIBLE = 0.02;

/**
 * A model whose parts have the mean of their vertex colours in their base colour, with a warning where these differ.
 *
 * For rooms of visitors: rooms are shaded by vertex colours as by baked occlusion, which those of built-in rooms are.
 */
export function withMeanColors(model: Model): Model {
  let differ = false;
  const parts = model.parts.map((part): Part => {
    const { colors, material } = part;
    if (!colors) return part;
    const areas = areasOf(part);
    const whole = areas.reduce((sum, area) => sum + area, 0);
    const channel = (i: number) => colors.filter((_, at) => at % 4 === i);
    const tint = (i: 0 | 1 | 2 | 3) => {
      const mean = channel(i).reduce((sum, x, vertex) => sum + x * (areas[vertex] ?? 0), 0) / whole;
      differ ||= channel(i).some((x) => Math.abs(x - mean) > VISIBLE);
      return material.baseColor[i] * mean;
    };
    const baseColor = [tint(0), tint(1), tint(2), tint(3)] as const;
    return { ...part, colors: null, material: { ...material, baseColor } };
  });
  if (differ) console.warn("Vertex colours count in their mean, for each mesh and material.");
  return { ...model, parts };
}

/** Area of the triangles around each vertex, times 2: its colour counts by that. All are equal where there is none. */
function areasOf(part: Part): Float64Array {
  const areas = new Float64Array(part.positions.length / 3);
  for (let i = 0; i < part.indices.length; i += 3) {
    const area = Math.hypot(...crossOf(verticesOf(part, i / 3)));
    for (const corner of part.indices.subarray(i, i + 3))
      areas[corner] = (areas[corner] ?? 0) + area;
  }
  return areas.some((area) => area > 0) ? areas : areas.fill(1);
}
