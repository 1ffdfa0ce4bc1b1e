/**
 * What the cabin and the chamberstick are made of: a texture set of public/textures/, tinted or not,
 * or a plain surface. Albedo in linear Rec. 709.
 */
const textured = (textures, { tint = [1, 1, 1], metallic = 0 } = {}) => ({
  textures,
  baseColor: tint,
  roughness: 1,
  metallic,
});

const plain = (baseColor, roughness) => ({ baseColor, roughness, metallic: 0 });

export const materials = {
  logs: textured("logs", { tint: [0.83, 0.92, 1] }),
  logends: textured("logends"),
  trim: textured("trim", { tint: [0.78, 0.76, 0.74] }),
  pine: textured("trim", { tint: [0.97, 0.98, 1] }),
  planks: textured("planks"),
  mortar: textured("plaster", { tint: [0.41, 0.42, 0.46] }),
  stone: textured("stone"),
  "stone-sooty": textured("stone", { tint: [0.16, 0.15, 0.145] }),
  brass: textured("brass", { metallic: 1 }),
  iron: textured("iron", { metallic: 1 }),
  pewter: textured("pewter", { metallic: 1 }),
  linen: textured("linen", { tint: [0.91, 0.97, 1] }),
  rush: textured("linen", { tint: [0.62, 0.52, 0.32] }),
  broadcloth: textured("linen", { tint: [0.1, 0.125, 0.15] }),
  wool: textured("wool"),
  leather: textured("leather", { tint: [0.26, 0.17, 0.105] }),
  "cloth-blue": textured("leather", { tint: [0.09, 0.115, 0.14] }),
  "cloth-red": textured("leather", { tint: [0.3, 0.05, 0.042] }),
  paper: textured("paper"),
  wax: textured("wax"),
  glass: plain([0.002, 0.002, 0.002], 0.05),
  "looking-glass": textured("mirror", { metallic: 1 }),
  pane: plain([0.02, 0.02, 0.02], 0.02),
  night: plain([0, 0, 0], 1),
  charcoal: textured("char"),
  ash: textured("plaster", { tint: [0.54, 0.56, 0.63] }),
  // Clear: more of the light goes down into the wax than from the wax that is solid.
  pool: plain([0.5, 0.44, 0.3], 0.03),
  wick: plain([0.012, 0.011, 0.01], 0.9),
};
