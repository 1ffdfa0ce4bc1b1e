// Light that comes back from what the candle stands on, which the few probes of a room cannot tell from it.
// Needs physical/light.glsl.

uniform sampler2D uBelow;  // deferred/below.frag

// Farther from the candle's axis than this, probes say it. Metres.
const float BESIDE = 0.15;
// Of the radiosity at the candle's foot, what reaches a surface over it that faces down. An endless plane gives
// .21 to .33 at 3 to 20 cm, outside of the holder's shadow; tables end, and holders have rims: as high draws it.
const float SEEN = 0.16;

// So far above the plane it is seen; what lies on it does not see it. Metres.
const float ABOVE = 0.02;

// lx, for 1 cd of the flame's, on a surface to whose hemisphere the plane is such a share.
vec3 fromBelow(vec3 position, float share) {
  vec4 below = texelFetch(uBelow, ivec2(0), 0);
  vec2 aside = (position.xz - light.axis) / BESIDE;
  float near = clamp((position.y - below.a) / ABOVE, 0.0, 1.0) * exp(-dot(aside, aside));
  return below.rgb * (SEEN * near * share);
}

// The nearest half of what a wall sees of it is in the holder's shadow.
float faces(vec3 normal) {
  float share = 0.5 - 0.5 * normal.y;
  return share * share;
}
