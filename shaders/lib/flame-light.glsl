// The flame as a lamp: a capsule, equally intense from all sides, on its candle.

layout(std140) uniform Light {
  vec3 position;     // centre of the light, m
  float halfHeight;  // m
  vec3 intensity;    // cd
  float radius;      // m
  vec2 axis;         // of the candle: x and z, m
  float rim;         // height of the candle's top, m
  float rimRadius;   // m
  float pan;         // height of the holder's pan, m
  float panRadius;   // m
  vec3 vantage;      // that captures were made from, near the centre of the light, m
  vec3 along;        // direction of the flame's axis, length 1
} light;

// The candle's edge stands so much above its top, on an average around it, m.
const float LIP = 0.0007;

// Where a light at `from` passes a level disc around the candle's axis on its way to `to`, which is below:
// 0 where the light's near end grazes its edge, 1 where its far end does.
float discPenumbra(vec3 from, vec3 to, float height, float radius) {
  vec3 descent = vec3(from.x, max(from.y, height + 1e-4), from.z) - to;
  float way = (height - to.y) / descent.y;
  float away = distance(mix(to.xz, from.xz, way), light.axis) - radius;
  // The light's width, as the disc's edge throws it.
  float blur = (light.radius * length(descent) / descent.y + 1e-4) * way + 1e-4;
  return 0.5 + 0.5 * away / blur;
}

// Integral of a smooth step from 0 to 1.
float smoothstepIntegral(float x) {
  float t = clamp(x, 0.0, 1.0);
  return t * t * t * (1.0 - 0.5 * t) + max(x - 1.0, 0.0);
}

// Share of the flame that a disc leaves in sight: as long as it is, each part of it is as wide.
float discVisibility(vec3 position, float height, float radius) {
  if (position.y >= height) return 1.0;
  vec3 reach = light.along * light.halfHeight;
  float low = discPenumbra(light.position - reach, position, height, radius);
  float high = discPenumbra(light.position + reach, position, height, radius);
  float middle = smoothstep(0.0, 1.0, 0.5 * (low + high));
  return abs(high - low) < 1e-2 ? middle : (smoothstepIntegral(high) - smoothstepIntegral(low)) / (high - low);
}

// Share of the flame that candle and holder leave in sight. They are a centimetre from the light, too
// near for a shadow map, and simple enough to do without: each is a disc.
float candleVisibility(vec3 position) {
  if (position.y > light.rim) return 1.0;
  float pan = position.y < light.pan - 0.004 ? discVisibility(position, light.pan, light.panRadius) : 1.0;
  return min(pan, discVisibility(position, light.rim + LIP, light.rimRadius));
}

// The wick glows where it reaches out of the dark zone: heights above the candle's rim, m.
const float EMBER_BEGINS = 0.0028;
const float EMBER_FULL = 0.0052;

// Share of the glow of the wick's tip at a place on the wick.
float emberShare(vec3 position) {
  return smoothstep(EMBER_BEGINS, EMBER_FULL, position.y - light.rim);
}
