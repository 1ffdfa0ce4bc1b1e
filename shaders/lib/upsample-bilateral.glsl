// Joint bilateral upsampling of reduced lighting, by depth: linear where the four texels around lie on the pixel's
// surface, else towards those that do. REPROJECTED: G-buffer and lighting are the previous frame's, reprojected.
// Needs lib/depth.glsl, lib/gbuffer.glsl, and REPROJECTED lib/reproject.glsl.
// After Kopf, Cohen, Lischinski and Uyttendaele 2007, "Joint Bilateral Upsampling".

uniform sampler2D uGBufferAlbedo;
uniform sampler2D uLighting;
uniform sampler2D uInverseDepthGather;  // inverse depth of the lighting's texels: opaque/gather-inverse-depth.frag

// Largest difference of depth within a surface, as a share of the depth.
const float DEPTH_TOLERANCE = 0.03;
// Weight of a texel of another surface, where there is no better one.
const float LEAST_WEIGHT = 0.01;

// Selection without branches, here and below, which is faster on a CPU.
#if REPROJECTED
// The pixel's surface in the previous frame: uv and depth. Its albedo replaces `albedo`, but for disocclusions,
// which keep what the G-buffer has at the pixel.
vec3 reprojectSurface(vec2 uv, inout vec4 albedo) {
  vec4 current = vec4(uv, texture(uDepth, uv).r, 1.0);
  float isHeld = isHeldSurface(albedo.a);
  vec2 previous = previousUv(current, isHeld);
  vec4 previousAlbedo = texture(uGBufferAlbedo, previous);
  float disoccluded = isDisoccluded(isHeld, previousAlbedo.a);
  albedo = mix(previousAlbedo, albedo, disoccluded);
  return mix(vec3(previous, texture(uDepth, previous).r), current.xyz, disoccluded);
}

// Depth in the current frame of the reprojected surface.
float frameDepth(vec2 uv) {
  vec4 albedo = texture(uGBufferAlbedo, uv);
  mat4 previousFromCurrent = isHeldSurface(albedo.a) > 0.5 ? uPreviousFromCurrentHeld : uPreviousFromCurrentRoom;
  float previous = reprojectSurface(uv, albedo).z;
  vec4 atNearPlane = previousFromCurrent * vec4(uv, 0.0, 1.0);
  return (previous * atNearPlane.w - atNearPlane.z) / (previousFromCurrent[2].z - previous * previousFromCurrent[2].w);
}
#else
vec3 reprojectSurface(vec2 uv, vec4 albedo) {
  return vec3(uv, texture(uDepth, uv).r);
}

float frameDepth(vec2 uv) {
  return texture(uDepth, uv).r;
}
#endif

// Where a pixel reads its lighting.
vec2 lightingUv(vec2 uv, inout vec4 albedo) {
  vec3 surface = reprojectSurface(uv, albedo);
  float center = inverseDepth(surface.z);
  vec2 size = vec2(textureSize(uLighting, 0));
  vec2 texel = clamp(surface.xy * size - 0.5, vec2(0.0), size - 1.0);
  vec2 corner = floor(texel);
  vec2 fraction = texel - corner;
  vec4 gathered = texelFetch(uInverseDepthGather, ivec2(corner), 0);
  vec2 rows = mix(gathered.xz, gathered.yw, fraction.x);
  // Inverse depth is linear across a plane.
  bool isSameSurface = abs(mix(rows.x, rows.y, fraction.y) - center) < DEPTH_TOLERANCE * center;
  vec4 weights = max(DEPTH_TOLERANCE * center - abs(gathered - center), LEAST_WEIGHT * DEPTH_TOLERANCE * center);
  weights *= vec4(1.0 - fraction.x, fraction.x, 1.0 - fraction.x, fraction.x);
  weights *= vec4(1.0 - fraction.yy, fraction.yy);
  vec2 weighted = vec2(weights.y + weights.w, weights.z + weights.w) / dot(weights, vec4(1.0));
  return (corner + 0.5 + (isSameSurface ? fraction : weighted)) / size;
}
