// Light from the surface that the candle stands on, which sparse probes do not resolve.
// Needs lib/flame-light.glsl.

uniform sampler2D uSupport;  // radiosity and height of that surface, a texel a flame: gi/support-radiosity.frag
#ifdef CANDLES
uniform sampler2D uStandingSupport;
#endif

// Distance from the candle's axis over which it fades to the probes' light, m.
const float RADIUS = 0.15;
// Form factor of the surface for a facet that faces it, beside what probes give. Fitted by eye to the candle at high;
// an endless plane would give 0.21 to 0.33 outside of the holder's shadow, 3 to 20 cm above it.
const float FORM_FACTOR = 0.1;
// Height over the surface from which it has full effect, m: surfaces on it do not face it.
const float FADE = 0.02;
// Heights over it between which it ceases to fill the view down, m: a wall over a sill, not the candle.
const vec2 CEASES = vec2(0.25, 0.5);

// Radiosity and height of the surface below the flame that is shaded for.
vec4 supportOfLight() {
  ivec2 texel = ivec2(int(light.shadowSlot), 0);
#ifdef CANDLES
  if (isStanding) return texelFetch(uStandingSupport, texel, 0);
#endif
  return texelFetch(uSupport, texel, 0);
}

// lx, for 1 cd of the flame's.
vec3 supportIrradiance(vec4 support, vec3 position, float viewFactor) {
  vec2 offset = (position.xz - light.axis) / RADIUS;
  float height = position.y - support.a;
  float weight = clamp(height / FADE, 0.0, 1.0) * (1.0 - smoothstep(CEASES.x, CEASES.y, height)) * exp(-dot(offset, offset));
  return support.rgb * (FORM_FACTOR * weight * viewFactor);
}

// Of a diffuse surface: the nearest half of what a wall faces is in the holder's shadow.
float supportViewFactor(vec3 normal) {
  float share = 0.5 - 0.5 * normal.y;
  return share * share;
}
