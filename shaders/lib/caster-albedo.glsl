// Caster albedo: a tile for each surface of a model, with its levels of detail one above another.

const int CASTER_TILE = 16;  // texels along an edge of the finest level: src/render/shadow/caster-albedo.ts
const int CASTER_LEVELS = 5;

const int CASTER_COLUMNS = 128;  // tiles side by side: 2048 texels fit everywhere

// Lowest texel of a surface's tile, by its number.
ivec2 casterTile(int surface) {
  return ivec2(surface % CASTER_COLUMNS, 2 * (surface / CASTER_COLUMNS)) * CASTER_TILE;
}

// Texels along an edge of a level.
int casterLevelSize(int level) {
  return CASTER_TILE >> level;
}

int casterLevelRow(int level) {
  return 2 * (CASTER_TILE - casterLevelSize(level));
}
