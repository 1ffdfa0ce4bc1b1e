// The flame as a light source: a capsule, equally intense in all directions, on its candle.
// CANDLES: in shaders that shade for standing candles as well, the most of them. FLAMES: in those of lib/candle-flames.glsl.

struct FlameLight {
  vec3 position;     // centre of the capsule, m
  float halfHeight;  // m
  vec3 intensity;    // cd
  float radius;      // m
  vec2 axis;         // of the candle: x and z, m
  float rim;         // height of the candle's top, m
  float rimRadius;   // m
  float pan;         // height of the holder's pan, m
  float panRadius;   // m
  vec3 captureOrigin;  // of the shadow cube and the surfels, near the centre of the capsule, m
  float shadowSlot;  // place of its shadow cube, and of its support, in their textures
  vec3 along;        // direction of the capsule's axis, length 1
};

#ifdef CANDLES
layout(std140) uniform Light {
  FlameLight carried;
};
layout(std140) uniform Candles {
  FlameLight candles[CANDLES];
  float count;
} standing;

FlameLight light;         // the flame that is shaded for
bool isStanding = false;  // whether it is a standing candle's
#elif defined(FLAMES)
FlameLight light;
#else
layout(std140) uniform Light {
  FlameLight light;
};
#endif

// Height of the candle's lip over its top, mean around it, m.
const float LIP = 0.0007;
// Depth of the dish of melted wax below the candle's top, m, and its radius, as a share of the top's.
const float DISH = 0.003;
const float DISH_RADIUS = 0.9;

// Penumbra of a horizontal disc around the candle's axis, by a point of the light, at a receiver below the disc: 0
// where the disc hides all of the capsule's width, 1 where none.
float discPenumbra(vec3 from, vec3 to, float height, float radius) {
  vec3 descent = vec3(from.x, max(from.y, height + 1e-4), from.z) - to;
  float way = (height - to.y) / descent.y;
  float clearance = distance(mix(to.xz, from.xz, way), light.axis) - radius;
  // The capsule's width, projected through the disc's edge.
  float blur = (light.radius * length(descent) / descent.y + 1e-4) * way + 1e-4;
  return 0.5 + 0.5 * clearance / blur;
}

float smoothstepIntegral(float x) {
  float t = clamp(x, 0.0, 1.0);
  return t * t * t * (1.0 - 0.5 * t) + max(x - 1.0, 0.0);
}

// Visible share of the capsule past a disc: the mean of its penumbra along the capsule.
float discVisibility(vec3 position, float height, float radius) {
  if (position.y >= height || radius <= 0.0) return 1.0;
  vec3 halfAxis = light.along * light.halfHeight;
  float low = discPenumbra(light.position - halfAxis, position, height, radius);
  float high = discPenumbra(light.position + halfAxis, position, height, radius);
  float middle = smoothstep(0.0, 1.0, 0.5 * (low + high));
  return abs(high - low) < 1e-2 ? middle : (smoothstepIntegral(high) - smoothstepIntegral(low)) / (high - low);
}

// Visible share of the capsule past candle and holder, each a disc: a centimetre from the light they are too near for
// a shadow map.
float candleVisibility(vec3 position) {
  bool isInDish = position.y > light.rim - DISH && distance(position.xz, light.axis) < DISH_RADIUS * light.rimRadius;
  if (position.y > light.rim || isInDish) return 1.0;
  float pan = position.y < light.pan - 0.004 ? discVisibility(position, light.pan, light.panRadius) : 1.0;
  return min(pan, discVisibility(position, light.rim + LIP, light.rimRadius));
}
