import type { Model, Part } from "../assets/model.js";

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
    const channel = (i: number) => colors.filter((_, at) => at % 4 === i);
    const tint = (i: 0 | 1 | 2 | 3) => {
      const mean = channel(i).reduce((sum, x) => sum + x, 0) / (colors.length / 4);
      differ ||= channel(i).some((x) => Math.abs(x - mean) > VISIBLE);
      return material.baseColor[i] * mean;
    };
    const baseColor = [tint(0), tint(1), tint(2), tint(3)] as const;
    return { ...part, colors: null, material: { ...material, baseColor } };
  });
  if (differ) console.warn("Vertex colours count in their mean, for each mesh and material.");
  return { ...model, parts };
}
