// Traced reflections: a mirrored ray, marched through the cube of distances from the flame, which holds every surface
// that the flame lights. Szirmay-Kalos, Aszódi, Lazányi and Premecz 2005, "Approximate Ray-Tracing on the GPU with
// Distance Impostors". Needs lib/photometry.glsl, lib/flame-light.glsl, lib/shadow-cube.glsl,
// lib/surfels.glsl.

uniform sampler2D uRadiosity;  // of the surfels, lm/m²

// Steps of the march: first and last distance, m, and the ratio of each to the one before.
const float NEAREST_STEP = 0.04;
const float FARTHEST_STEP = 9.0;
const float GROWTH = 1.25;
const int BISECTIONS = 6;
const float IMPOSTOR_BIAS = 0.02;  // m
// Depth behind a surface up to which a ray hits it for certain, and from which it passes behind. Metres.
const vec2 THICKNESS = vec2(0.06, 0.25);

// Depth of a point behind the surface in its direction from the capture origin, m.
float depthBehind(vec3 fromOrigin) {
  return length(fromOrigin) * (1.0 - casterDistance(fromOrigin)) - IMPOSTOR_BIAS;
}

// Radiosity in a direction from the capture origin, filtered within a face, lm/m².
vec3 radiosityToward(vec3 fromOrigin) {
  int size = textureSize(uRadiosity, 0).y;
  vec3 uv = cubeFaceUv(fromOrigin);
  vec2 at = clamp(uv.xy * float(size) - 0.5, vec2(0.0), vec2(float(size) - 1.0));
  ivec2 corner = min(ivec2(at), size - 2);
  vec2 share = at - vec2(corner);
  corner.x += int(uv.z) * size;
  vec3 low = mix(texelFetch(uRadiosity, corner, 0).rgb, texelFetch(uRadiosity, corner + ivec2(1, 0), 0).rgb, share.x);
  vec3 high = mix(texelFetch(uRadiosity, corner + ivec2(0, 1), 0).rgb, texelFetch(uRadiosity, corner + 1, 0).rgb, share.x);
  return mix(low, high, share.y);
}

// Reflected direct light along a ray, cd/m² for 1 cd; black where it hits no surface that the flame lights.
vec3 traceRadiance(vec3 position, vec3 ray) {
  vec3 start = position - light.captureOrigin;
  float near = NEAREST_STEP;
  bool wasBehind = depthBehind(start + ray * near) > 0.0;
  vec3 sum = vec3(0.0);
  float transmittance = 1.0;
  for (float far = NEAREST_STEP * GROWTH; far < FARTHEST_STEP && transmittance > 0.01; far *= GROWTH) {
    bool isBehind = depthBehind(start + ray * far) > 0.0;
    if (isBehind != wasBehind) {
      float low = near;
      float high = far;
      for (int i = 0; i < BISECTIONS; i++) {
        float middle = 0.5 * (low + high);
        if (depthBehind(start + ray * middle) > 0.0 == isBehind) high = middle;
        else low = middle;
      }
      vec3 hit = start + ray * (isBehind ? high : low);
      float opacity = transmittance * (1.0 - smoothstep(THICKNESS.x, THICKNESS.y, depthBehind(hit)));
      // A ray that leaves a shadow through its caster hits the caster's unlit side.
      if (isBehind) sum += opacity * radiosityToward(hit);
      transmittance -= opacity;
    }
    wasBehind = isBehind;
    near = far;
  }
  return sum / PI;
}
