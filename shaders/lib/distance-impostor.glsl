// The room in a smooth surface.
// Needs lib/photometry.glsl, lib/flame-light.glsl, lib/pcss.glsl, lib/surfels.glsl.
//
// Whatever the flame lights is in its sight: the cube of distances from it is the shape of all that is bright,
// so a mirrored ray is followed through that cube until it falls behind what the flame sees there.
// After Szirmay-Kalos, Aszódi, Lazányi and Premecz 2005, "Approximate Ray-Tracing on the GPU with Distance Impostors".

uniform sampler2D uRadiosity;  // of the patches that the flame sees, lm/m²

// The ray's steps: first and last distance, m, and each to the one before.
const float NEAREST_STEP = 0.04;
const float FARTHEST_STEP = 9.0;
const float GROWTH = 1.25;
const int BISECTIONS = 6;
const float BIAS_MIRRORED = 0.02;  // m
// How deep behind an edge, m, the ray still meets it, and from where on it passes.
const vec2 THICKNESS = vec2(0.06, 0.25);

// How far a place is behind what the flame sees in its direction, m.
float depthBehind(vec3 fromVantage) {
  return length(fromVantage) - textureLod(uShadow, fromVantage, 0.0).r - BIAS_MIRRORED;
}

// Radiosity of the patches around a direction from the flame, of one face, lm/m².
vec3 radiosityToward(vec3 fromVantage) {
  int size = textureSize(uRadiosity, 0).y;
  vec3 place = cubeFaceUv(fromVantage);
  vec2 at = clamp(place.xy * float(size) - 0.5, vec2(0.0), vec2(float(size) - 1.0));
  ivec2 corner = min(ivec2(at), size - 2);
  vec2 share = at - vec2(corner);
  corner.x += int(place.z) * size;
  vec3 low = mix(texelFetch(uRadiosity, corner, 0).rgb, texelFetch(uRadiosity, corner + ivec2(1, 0), 0).rgb, share.x);
  vec3 high = mix(texelFetch(uRadiosity, corner + ivec2(0, 1), 0).rgb, texelFetch(uRadiosity, corner + 1, 0).rgb, share.x);
  return mix(low, high, share.y);
}

// Radiance of the flame's own light where a ray ends, cd/m² for 1 cd; black where the flame sees nothing of it.
vec3 traceRadiance(vec3 position, vec3 ray) {
  vec3 start = position - light.vantage;
  float near = NEAREST_STEP;
  bool wasBehind = depthBehind(start + ray * near) > 0.0;
  vec3 sum = vec3(0.0);
  float unmet = 1.0;
  for (float far = NEAREST_STEP * GROWTH; far < FARTHEST_STEP && unmet > 0.01; far *= GROWTH) {
    bool isBehind = depthBehind(start + ray * far) > 0.0;
    if (isBehind != wasBehind) {
      float low = near;
      float high = far;
      for (int i = 0; i < BISECTIONS; i++) {
        float middle = 0.5 * (low + high);
        if (depthBehind(start + ray * middle) > 0.0 == isBehind) high = middle;
        else low = middle;
      }
      vec3 end = start + ray * (isBehind ? high : low);
      float met = unmet * (1.0 - smoothstep(THICKNESS.x, THICKNESS.y, depthBehind(end)));
      // Who comes out of a shadow through what throws it meets its dark side.
      if (isBehind) sum += met * radiosityToward(end);
      unmet -= met;
    }
    wasBehind = isBehind;
    near = far;
  }
  return sum / PI;
}
