// Light that comes back from what the candle stands on, which the few probes of a room cannot tell from it.
// Needs lib/flame-light.glsl.

uniform sampler2D uSupport;  // gi/support-radiosity.frag

// Farther from the candle's axis than this, probes say it. Metres.
const float BESIDE = 0.15;
// Of the radiosity at the candle's foot, what reaches a surface over it that faces down: chosen so that low looks
// as high does. An endless plane would give .21 to .33 outside of the holder's shadow, 3 to 20 cm above it.
const float SEEN = 0.16;
// What lies on the plane does not see it; from this height on it is seen. Metres.
const float ABOVE = 0.02;

// lx, for 1 cd of the flame's.
vec3 supportIrradiance(vec3 position, float viewFactor) {
  vec4 below = texelFetch(uSupport, ivec2(0), 0);
  vec2 aside = (position.xz - light.axis) / BESIDE;
  float near = clamp((position.y - below.a) / ABOVE, 0.0, 1.0) * exp(-dot(aside, aside));
  return below.rgb * (SEEN * near * viewFactor);
}

// Of the plane, for a matt surface: the nearest half of what a wall sees is in the holder's shadow.
float supportViewFactor(vec3 normal) {
  float share = 0.5 - 0.5 * normal.y;
  return share * share;
}
