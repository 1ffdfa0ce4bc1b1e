#version 300 es
// The flame: light of soot and of the blue base, gathered along the ray, with a little absorption.
// In:  the body, over radius and height.   Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-body.glsl"

uniform sampler2D uBody;     // soot's red and green, cd/m² per m; absorption, 1/m; blue bands, cd/m² per m
uniform sampler2D uOutline;  // red: radius over height, share of the largest

in vec3 vPosition;

out vec4 oRadiance;

// The CH* and C2* bands, luma 1. Their linear Rec. 709 is (0.2, 1.05, 2.9), but candlelight is all but without
// blue, and what turns it to white channel by channel brightens blue far more than an eye's cones do.
const vec3 BLUE = vec3(0.25, 1.3, 0.08);
// Blue of soot as a share of its red, and green from which on it has as much: src/light/color.ts.
const float LEAST_BLUE = 0.004;
const float COOL = 0.2;
const float WICK_RADIUS = 0.0009;  // m

// Table coordinates of a place: radius and height, as shares. Outside of 0 to 1 there is nothing.
vec2 bodyUv(vec3 position) {
  float last = float(NODES - 1);
  float place = position.y / flame.top * last;
  float inside = clamp(place, 0.0, last);
  int node = int(clamp(floor(inside + 0.5), 1.0, last - 1.0));
  float f = inside - float(node);
  // A quadratic spline through the nodes, and its slope.
  vec3 weight = vec3(0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f));
  vec3 slope = vec3(f - 0.5, -2.0 * f, f + 0.5);
  vec4 a = flame.nodes[node - 1];
  vec4 b = flame.nodes[node];
  vec4 c = flame.nodes[node + 1];
  vec4 rising = a * slope.x + b * slope.y + c * slope.z;
  vec4 here = a * weight.x + b * weight.y + c * weight.z + rising * (place - inside);
  vec3 tangent = normalize(vec3(rising.x, flame.top / last, rising.y));
  // The section is round across the spine, not across the vertical.
  vec2 aside = position.xz - here.xy;
  float along = dot(aside, tangent.xz);
  float height = here.z + along / flame.extent;
  float outer = flame.radius * here.w * texture(uOutline, vec2(height, 0.5)).r;
  float away = sqrt(max(dot(aside, aside) - along * along, 0.0));
  return vec2(away / (max(outer, 1e-5) * BODY_REACH), height);
}

// Where a ray from `eye` enters and leaves the balls; nothing where it misses them all.
vec2 within(vec3 eye, vec3 direction) {
  vec2 span = vec2(1e9, -1e9);
  for (int i = 0; i < BALLS; i++) {
    vec3 fromBall = eye - flame.balls[i].xyz;
    float b = dot(fromBall, direction);
    vec3 aside = fromBall - b * direction;
    float chord = flame.balls[i].w * flame.balls[i].w - dot(aside, aside);
    if (chord <= 0.0) continue;
    float half_ = sqrt(chord);
    span = vec2(min(span.x, -b - half_), max(span.y, -b + half_));
  }
  return span;
}

// Distance to the wick, a straight rod from the foot, or far away if the ray misses it.
float intersectWick(vec3 eye, vec3 direction) {
  float squared = dot(flame.wick, flame.wick);
  float d = dot(direction, flame.wick);
  float e = dot(eye, flame.wick);
  float a = squared - d * d;
  float b = squared * dot(eye, direction) - e * d;
  float c = squared * (dot(eye, eye) - WICK_RADIUS * WICK_RADIUS) - e * e;
  float h = b * b - a * c;
  if (h < 0.0 || a <= 0.0) return 1e9;
  float way = (-b - sqrt(h)) / a;
  float height = e + way * d;
  return height > 0.0 && height < squared ? way : 1e9;
}

void main() {
  vec3 eye = frame.eyePosition - flame.base;
  vec3 direction = normalize(vPosition - eye);
  vec2 span = within(eye, direction);
  float begin = max(span.x, 0.0);
  float end = min(span.y, intersectWick(eye, direction));
  if (end <= begin) discard;
  float stride = (end - begin) / flame.steps;
  vec3 radiance = vec3(0.0);
  float depth = 0.0;  // optical
  for (float i = 0.5; i < flame.steps; i++) {
    vec2 place = bodyUv(eye + direction * (begin + i * stride));
    if (place.x >= 1.0 || place.y <= 0.0 || place.y >= 1.0) continue;
    vec4 body = texture(uBody, place);
    float absorbed = body.b * flame.soot * stride;
    float warmth = min(body.g / max(COOL * body.r, 1e-6), 1.0);
    float cubed = warmth * warmth * warmth;
    vec3 soot = vec3(body.rg, LEAST_BLUE * cubed * cubed * body.r) * flame.soot;
    radiance += exp(-depth - 0.5 * absorbed) * stride * (soot + BLUE * (body.a * flame.blue));
    depth += absorbed;
  }
  // The largest half float is 65504. A flame blown small comes near, and must not turn green there.
  float peak = max(radiance.r, max(radiance.g, radiance.b));
  oRadiance = vec4(radiance * min(1.0, 3e4 / max(peak, 1e-6)), 1.0 - exp(-depth));
}
