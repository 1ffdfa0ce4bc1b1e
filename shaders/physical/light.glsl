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

// Share of a light at `from` that passes a level disc around the candle's axis on its way to `to`.
float passDisc(vec3 from, vec3 to, float height, float radius) {
  float way = (height - to.y) / max(from.y - to.y, 1e-4);
  if (way <= 0.0 || way >= 1.0) return 1.0;
  float away = distance(mix(to.xz, from.xz, way), light.axis);
  float blur = light.radius * way + 1e-4;  // the flame's width, as the disc's edge throws it
  return smoothstep(radius - blur, radius + blur, away);
}

// Share of the flame that candle and holder leave in sight. They are a centimetre from the light, too
// near for a shadow map, and simple enough to do without: each is a disc. Three points of the flame.
float pastCandle(vec3 position) {
  if (position.y > light.rim) return 1.0;
  float share = 0.0;
  for (int i = -1; i <= 1; i++) {
    vec3 from = light.position + light.along * (float(i) * 0.7 * light.halfHeight);
    float pan = position.y < light.pan - 0.004 ? passDisc(from, position, light.pan, light.panRadius) : 1.0;
    share += pan * passDisc(from, position, light.rim, light.rimRadius);
  }
  return share / 3.0;
}

// The wick glows where it reaches out of the dark zone: heights above the candle's rim, m.
const float EMBER_BEGINS = 0.0028;
const float EMBER_FULL = 0.0052;

// Share of the glow of the wick's tip at a place on the wick.
float emberShare(vec3 position) {
  return smoothstep(EMBER_BEGINS, EMBER_FULL, position.y - light.rim);
}
