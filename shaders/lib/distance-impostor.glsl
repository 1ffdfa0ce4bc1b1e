// Traced reflections: a mirrored ray, marched through the cube of distances from the flame, which holds every surface
// that the flame lights. Szirmay-Kalos, Aszódi, Lazányi and Premecz 2005, "Approximate Ray-Tracing on the GPU with
// Distance Impostors". The candle, which the cube leaves out, is a cylinder on a disc. Needs lib/frame.glsl,
// lib/photometry.glsl, lib/flame-light.glsl, lib/wax.glsl, lib/shadow-cube.glsl, lib/surfels.glsl.

uniform sampler2D uTotalRadiosity;  // radiosity of the surfels in all light, lm/m²

// Steps of the march: first and last distance, m, and the ratio of each to the one before.
const float NEAREST_STEP = 0.04;
const float FARTHEST_STEP = 9.0;
const float GROWTH = 1.7;
const float LEAST_COSINE = 0.05;  // between a surface's normal and what it mirrors, or is seen from
// Until the hit is known to less than THICKNESS, 9 m away as well: else a wall is taken for its edge, in rings.
const int BISECTIONS = 7;
const float IMPOSTOR_BIAS = 0.02;  // m
// Depth behind a surface up to which a ray hits it for certain, and from which it passes behind. Metres.
const vec2 THICKNESS = vec2(0.06, 0.25);
// Distance from a surfel's plane, m, at which a point is half as likely to be of its surface.
const float PLANE_TOLERANCE = 0.01;

// Light along a ray that hits nothing that the flame lights, as a share of the mean around it: the irradiance sample / PI.
const float TRACED_INDIRECT = 0.3;

// Albedo of wax, and about that of brass. Height of the pan's side, m.
const float CANDLE_ALBEDO = 0.7;
const float PAN_HEIGHT = 0.01;

// A surface as smooth as this is a mirror, by its alpha of GGX, and takes one ray.
const float MIRROR_ALPHA = 0.01;
const float GOLDEN_ANGLE = 2.399963;

// Depth of a point behind the surface in its direction from the capture origin, m.
float depthBehind(vec3 fromOrigin) {
  return length(fromOrigin) * (1.0 - casterDistance(fromOrigin)) - IMPOSTOR_BIAS;
}

// Radiosity at a point, from the capture origin, of the four surfels around its direction: those whose planes it lies in,
// lm/m². By the axes of a face of their cube.
vec3 radiosityAt(vec3 fromOrigin) {
  float size = float(textureSize(uTotalRadiosity, 0).y);
  int face = faceOf(fromOrigin);
  vec3 point = onFace(fromOrigin, face);
  vec2 at = clamp((0.5 + 0.5 * point.xy / point.z) * size - 0.5, 0.0, size - 1.001);
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int i = 0; i < 4; i++) {
    vec2 place = floor(at) + vec2(i & 1, i >> 1);
    ivec2 texel = ivec2(place + vec2(float(face) * size, 0.0));
    vec4 normalDistance = texelFetch(uSurfelNormalDistance, texel, 0);
    if (normalDistance.w <= 0.0) continue;
    vec3 surfel = vec3((place + 0.5) / size * 2.0 - 1.0, 1.0);
    surfel *= normalDistance.w * inversesqrt(dot(surfel, surfel));
    float outside = dot(onFace(normalDistance.xyz, face), surfel - point) / PLANE_TOLERANCE;
    vec2 shares = 1.0 - abs(place - at);
    float weight = (shares.x * shares.y + 1e-3) / (1.0 + outside * outside);
    sum += weight * texelFetch(uTotalRadiosity, texel, 0).rgb;
    total += weight;
  }
  return sum / max(total, 1e-9);
}

// Distance along a ray to a solid cylinder around the candle's axis, m; none for rays from above the pan: the holder's own
// reflections would be mottled.
float cylinderDistance(vec3 from, vec3 ray, float radius, vec2 heights) {
  vec2 offset = from.xz - light.axis;
  vec3 quadratic = vec3(dot(ray.xz, ray.xz) + 1e-9, dot(offset, ray.xz), dot(offset, offset) - radius * radius);
  float root = sqrt(max(quadratic.y * quadratic.y - quadratic.x * quadratic.z, 0.0));
  vec2 side = (vec2(-root, root) - quadratic.y) / quadratic.x;
  vec2 ends = (heights - from.y) / (abs(ray.y) < 1e-6 ? 1e-6 : ray.y);
  float enters = max(side.x, min(ends.x, ends.y));
  bool isOutside = radius > 0.0 && enters > 0.0 && dot(offset, offset) > light.panRadius * light.panRadius;
  return isOutside && enters < min(side.y, max(ends.x, ends.y)) ? enters : FARTHEST_STEP;
}

// Adds the radiosity that a ray hits, lm/m², and the share of it that hits nothing. `start`: from the capture origin, m;
// `nearest`: first step, m; `isMirrored`: by a mirror, in which wax glows. On a rough surface each ray would be a spot.
void traceRay(vec3 start, vec3 ray, float nearest, bool isMirrored, inout vec4 sum) {
  float before = depthBehind(start + ray * nearest);
  float transmittance = 1.0;
  vec3 from = start + light.captureOrigin;
  float candle = cylinderDistance(from, ray, light.rimRadius, vec2(light.pan, light.rim));
  candle = min(candle, cylinderDistance(from, ray, light.panRadius, vec2(light.pan - PAN_HEIGHT, light.pan)));
  for (float near = nearest; near * GROWTH < FARTHEST_STEP && near < candle && transmittance > 0.01; near *= GROWTH) {
    float far = min(near * GROWTH, candle);
    float depth = depthBehind(start + ray * far);
    bool isBehind = depth > 0.0;
    if (isBehind != before > 0.0) {
      vec2 low = vec2(near, before);  // distance along the ray, and depth
      vec2 high = vec2(far, depth);
      for (int i = 0; i < BISECTIONS; i++) {
        float middle = 0.5 * (low.x + high.x);
        vec2 between = vec2(middle, depthBehind(start + ray * middle));
        if (between.y > 0.0 == isBehind) high = between;
        else low = between;
      }
      float opacity = transmittance * (1.0 - smoothstep(THICKNESS.x, THICKNESS.y, max(low.y, high.y)));
      // A ray that leaves a shadow through its caster hits the caster's unlit side.
      if (isBehind) sum.rgb += opacity * radiosityAt(start + ray * mix(low.x, high.x, low.y / (low.y - high.y)));
      transmittance -= opacity;
    }
    before = depth;
  }
  // On the candle falls the mean light.
  bool isCandle = candle < FARTHEST_STEP;
  if (isCandle && isMirrored) sum.rgb += transmittance * CANDLE_ALBEDO * taperTransmission(from + ray * candle);
  sum.a += transmittance * (isCandle ? CANDLE_ALBEDO / TRACED_INDIRECT : 1.0);
}

// Light from around a mirrored direction, cd/m², by rays over the microfacets of a rough surface.
// `alpha`: GGX. `most`: rays for it. `beyond`: light along rays that hit nothing that the flame lights.
vec3 traceReflection(vec3 position, vec3 normal, float alpha, int most, vec3 beyond) {
  vec3 start = position - light.captureOrigin;
  vec4 sum = vec4(0.0);
  float count = 0.0;
  // Relief that is turned away would mirror nothing.
  vec3 toEye = normalize(frame.eyePosition - position);
  normal = normalize(normal + max(LEAST_COSINE - dot(normal, toEye), 0.0) * toEye);
  float halfTexel = SHADOW_REACH / shadowTileSize();
  for (int i = 0; i < most && (i == 0 || alpha >= MIRROR_ALPHA); i++) {
    // Slopes of GGX microfacets: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces".
    float u = alpha < MIRROR_ALPHA ? 0.0 : (float(i) + 0.5) / float(most);
    float slope = alpha * sqrt(u / (1.0 - u));
    float around = float(i) * GOLDEN_ANGLE;
    vec3 tangent = normalize(abs(normal.y) < 0.9 ? cross(normal, vec3(0.0, 1.0, 0.0)) : cross(normal, vec3(1.0, 0.0, 0.0)));
    vec3 facet = normalize(normal + slope * (cos(around) * tangent + sin(around) * cross(normal, tangent)));
    vec3 ray = reflect(-toEye, facet);
    if (dot(ray, normal) <= 0.0) continue;
    // Above the steps between texels of distance, of which a ray takes the nearest.
    float nearest = max(NEAREST_STEP, halfTexel * length(start) / max(dot(ray, normal), LEAST_COSINE));
    traceRay(start, ray, nearest, alpha < MIRROR_ALPHA, sum);
    count++;
  }
  return (sum.rgb / PI * light.intensity + sum.a * beyond) / max(count, 1.0);
}
