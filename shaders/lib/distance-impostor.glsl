// Traced reflections: a mirrored ray, marched through the cube of distances from the flame, which holds every surface
// that the flame lights. Szirmay-Kalos, Aszódi, Lazányi and Premecz 2005, "Approximate Ray-Tracing on the GPU with
// Distance Impostors". Needs lib/photometry.glsl, lib/flame-light.glsl, lib/shadow-cube.glsl,
// lib/surfels.glsl.

uniform sampler2D uTotalRadiosity;  // radiosity of the surfels in all light, lm/m²

// Steps of the march: first and last distance, m, and the ratio of each to the one before.
const float NEAREST_STEP = 0.04;
const float FARTHEST_STEP = 9.0;
const float GROWTH = 1.7;
const int BISECTIONS = 6;
const float IMPOSTOR_BIAS = 0.02;  // m
// Depth behind a surface up to which a ray hits it for certain, and from which it passes behind. Metres.
const vec2 THICKNESS = vec2(0.06, 0.25);
// Distance from a surfel's plane, m, at which a point is half as likely to be of its surface.
const float PLANE_TOLERANCE = 0.01;

// Light along a ray that hits nothing that the flame lights, as a share of the mean around it: the irradiance sample / PI.
const float TRACED_INDIRECT = 0.3;

// A surface as smooth as this is a mirror, by its alpha of GGX, and takes one ray.
const float MIRROR_ALPHA = 0.01;
const float GOLDEN_ANGLE = 2.399963;

// Depth of a point behind the surface in its direction from the capture origin, m.
float depthBehind(vec3 fromOrigin) {
  return length(fromOrigin) * (1.0 - casterDistance(fromOrigin)) - IMPOSTOR_BIAS;
}

// Radiosity at a point, from the capture origin, of the four surfels around its direction: those whose planes it lies in,
// lm/m².
vec3 radiosityAt(vec3 fromOrigin) {
  int size = textureSize(uTotalRadiosity, 0).y;
  vec3 uv = cubeFaceUv(fromOrigin);
  vec2 at = clamp(uv.xy * float(size) - 0.5, vec2(0.0), vec2(float(size) - 1.0));
  ivec2 corner = min(ivec2(at), size - 2);
  vec2 share = at - vec2(corner);
  corner.x += int(uv.z) * size;
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    Surfel surfel = surfelAt(corner + offset, size);
    if (surfel.distance <= 0.0) continue;
    vec2 shares = mix(1.0 - share, share, vec2(offset));
    float outside = dot(surfel.normal, surfel.position - light.captureOrigin - fromOrigin) / PLANE_TOLERANCE;
    float weight = (shares.x * shares.y + 1e-3) / (1.0 + outside * outside);
    sum += weight * texelFetch(uTotalRadiosity, corner + offset, 0).rgb;
    total += weight;
  }
  return sum / max(total, 1e-9);
}

// Light along a ray from surfaces that the flame lights, cd/m²; alpha: share of the ray that hits none.
vec4 traceRadiance(vec3 position, vec3 ray) {
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
      if (isBehind) sum += opacity * radiosityAt(hit);
      transmittance -= opacity;
    }
    wasBehind = isBehind;
    near = far;
  }
  return vec4(sum / PI * light.intensity, transmittance);
}

// Light from around a mirrored direction, cd/m², by rays over the microfacets of a rough surface.
// `alpha`: GGX. `most`: rays for it. `beyond`: light along rays that hit nothing that the flame lights.
vec3 traceReflection(vec3 position, vec3 normal, vec3 view, float alpha, int most, vec3 beyond) {
  vec3 tangent = normalize(abs(normal.y) < 0.9 ? cross(normal, vec3(0.0, 1.0, 0.0)) : cross(normal, vec3(1.0, 0.0, 0.0)));
  vec3 bitangent = cross(normal, tangent);
  int rays = alpha < MIRROR_ALPHA ? 1 : most;
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (int i = 0; i < rays; i++) {
    // Slopes of GGX microfacets: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
    float u = rays == 1 ? 0.0 : (float(i) + 0.5) / float(rays);
    float slope = alpha * sqrt(u / (1.0 - u));
    float around = float(i) * GOLDEN_ANGLE;
    vec3 facet = normalize(normal + slope * (cos(around) * tangent + sin(around) * bitangent));
    vec3 ray = reflect(-view, facet);
    if (dot(ray, normal) <= 0.0) continue;
    vec4 traced = traceRadiance(position, ray);
    sum += traced.rgb + traced.a * beyond;
    count++;
  }
  return sum / max(count, 1.0);
}
