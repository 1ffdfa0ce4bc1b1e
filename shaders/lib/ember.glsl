// The wick's glowing tip.

// Height of the wick's end above the candle's rim, m.
const float WICK_END = 0.0057;
// Below it the glow falls as a Gaussian of this length, m, up to this far from the candle's axis. Fitted by eye: a speck of 1
// to 2 mm glows.
const float EMBER_LENGTH = 0.0009;
const float EMBER_REACH = 0.006;

// Share of the ember's radiance at a point of the wick. `fromRim`: from the middle of the candle's rim, m.
float emberShare(vec3 fromRim) {
  float below = max(WICK_END - fromRim.y, 0.0) / EMBER_LENGTH;
  return exp(-below * below) * step(length(fromRim.xz), EMBER_REACH);
}
