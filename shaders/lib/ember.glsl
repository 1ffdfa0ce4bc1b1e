// The wick's glowing tip.

// The wick glows where it leaves the flame's dark zone: from and to these heights above the candle's rim, and to this
// far from the candle's axis, m.
const float EMBER_BEGINS = 0.0028;
const float EMBER_FULL = 0.0052;
const float EMBER_REACH = 0.006;

// Share of the ember's radiance at a point of the wick. `fromRim`: from the middle of the candle's rim, m.
float emberShare(vec3 fromRim) {
  return smoothstep(EMBER_BEGINS, EMBER_FULL, fromRim.y) * step(length(fromRim.xz), EMBER_REACH);
}
