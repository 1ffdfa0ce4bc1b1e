#version 300 es
// The flame, by ray marching: emission of soot and of the blue base, with absorption.
// In:  the body, over radius and height.   Out: radiance, cd/m², premultiplied by opacity.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/flame-body.glsl"

uniform sampler2D uBody;     // soot's red and green, cd/m² per m; absorption, 1/m; blue bands, cd/m² per m
uniform sampler2D uOutline;  // red: radius over height, share of the largest

out vec4 oRadiance;

// The CH* and C2* bands, luma 1. Their linear Rec. 709 is (0.2, 1.05, 2.9), but adaptation to candlelight by channel
// amplifies blue far more than that of an eye's cones.
const vec3 BLUE = vec3(0.25, 1.3, 0.08);
// Blue of soot as a share of its red, reached from this ratio of green to red on: src/light/color.ts.
const float SOOT_BLUE = 0.004;
const float WARM_GREEN = 0.2;
const float WICK_RADIUS = 0.00105;  // m

// What the body covers of a pixel's width, and half of that width, m.
float covered = 0.0;
float margin;

// Table coordinates of a point: radius and height, as shares. Outside of 0 to 1 the body is empty.
vec2 bodyUv(vec3 position) {
  float last = float(NODES - 1);
  float height = dot(position, flame.tip) / dot(flame.tip, flame.tip) * last;
  float inside = clamp(height, 0.0, last);
  int node = int(clamp(floor(inside + 0.5), 1.0, last - 1.0));
  float f = inside - float(node);
  // Quadratic B-spline through the nodes, and its derivative.
  vec3 weight = vec3(0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f));
  vec3 slope = vec3(f - 0.5, -2.0 * f, f + 0.5);
  vec4 a = flame.nodes[node - 1];
  vec4 b = flame.nodes[node];
  vec4 c = flame.nodes[node + 1];
  vec4 derivative = a * slope.x + b * slope.y + c * slope.z;
  vec4 here = a * weight.x + b * weight.y + c * weight.z + derivative * (height - inside);
  vec3 tangent = normalize(derivative.xyz);
  // The cross-section is round perpendicular to the spine.
  vec3 offset = position - here.xyz;
  float along = dot(offset, tangent);
  float share = here.w + along / flame.extent;
  float neck = dot(weight, vec3(flame.necks[node - 1].x, flame.necks[node].x, flame.necks[node + 1].x));
  float outer = flame.radius * neck * texture(uOutline, vec2(share, 0.5)).r;
  float distance = sqrt(max(dot(offset, offset) - along * along, 0.0));
#ifdef ALONE
  covered = max(covered, min(outer - distance, margin) + min(outer + distance, margin));
  outer += margin;
#endif
  return vec2(distance / (max(outer, 1e-5) * BODY_REACH), share);
}

// Distances at which a ray enters and leaves the bounding spheres; empty where it misses all of them.
vec2 intersectSpheres(vec3 eye, vec3 direction) {
  vec2 span = vec2(1e9, -1e9);
  for (int i = 0; i < SPHERES; i++) {
    vec3 fromSphere = eye - flame.spheres[i].xyz;
    float b = dot(fromSphere, direction);
    vec3 perpendicular = fromSphere - b * direction;
    float radius = flame.spheres[i].w + margin;
    float squaredHalfChord = radius * radius - dot(perpendicular, perpendicular);
    if (squaredHalfChord <= 0.0) continue;
    float halfChord = sqrt(squaredHalfChord);
    span = vec2(min(span.x, -b - halfChord), max(span.y, -b + halfChord));
  }
  return span;
}

// Distance to a cylinder around a piece of the wick, which overlaps with the next; 1e9 if the ray misses it.
float intersectPiece(vec3 eye, vec3 direction, vec3 piece) {
  float squared = dot(piece, piece);
  float d = dot(direction, piece);
  float e = dot(eye, piece);
  float a = squared - d * d;
  float b = squared * dot(eye, direction) - e * d;
  float c = squared * (dot(eye, eye) - WICK_RADIUS * WICK_RADIUS) - e * e;
  float h = b * b - a * c;
  if (h < 0.0 || a <= 0.0) return 1e9;
  float distance = (-b - sqrt(h)) / a;
  return abs((e + distance * d) / squared - 0.5) < 0.6 ? distance : 1e9;
}

float intersectWick(vec3 eye, vec3 direction) {
  float nearest = 1e9;
  for (int i = 0; i < WICK_NODES - 1; i++) {
    vec3 node = flame.wick[i].xyz;
    nearest = min(nearest, intersectPiece(eye - node, direction, flame.wick[i + 1].xyz - node));
  }
  return nearest;
}

void main() {
  margin = MARGIN;
  vec3 eye = frame.eyePosition - flame.base;
  // Not from an interpolated position: that is off by what the driver rounds vertices to, a sixteenth of a pixel in some.
  mat4 rows = transpose(frame.clipFromWorld);
  vec2 ndc = 2.0 * gl_FragCoord.xy / frame.viewport - 1.0;
  vec3 direction = normalize(cross((rows[1] - ndc.y * rows[3]).xyz, (rows[0] - ndc.x * rows[3]).xyz));
  vec2 span = intersectSpheres(eye, direction);
  float begin = max(span.x, 0.0);
  float end = min(span.y, intersectWick(eye, direction));
  if (end <= begin) discard;
  float stride = (end - begin) / flame.steps;
  vec3 radiance = vec3(0.0);
  float depth = 0.0;  // optical
  for (float i = 0.5; i < flame.steps; i++) {
    vec2 uv = bodyUv(eye + direction * (begin + i * stride));
    if (uv.x >= 1.0 || uv.y <= 0.0 || uv.y >= 1.0) continue;
    vec4 body = texture(uBody, uv);
    float absorbed = body.b * flame.soot * stride;
    float warmth = min(body.g / max(WARM_GREEN * body.r, 1e-6), 1.0);
    float cubed = warmth * warmth * warmth;
    vec3 soot = vec3(body.rg, SOOT_BLUE * cubed * cubed * body.r) * flame.soot;
    radiance += exp(-depth - 0.5 * absorbed) * stride * (soot + BLUE * (body.a * flame.blue));
    depth += absorbed;
  }
#ifdef ALONE
  // Antialiasing: the pixel is displayed with as large a share of the flame's colour as is covered, while that share of its
  // light would still be white. 2.5 and the hue, which bleaches like the flame's, are by the display's curves. In front of
  // the wick the ray ends before it has met the most of the body.
  bool isCovered = end < span.y || covered > 1.999 * margin;
  float coverage = isCovered ? 1.0 : 0.5 * covered / margin;
  float shown = coverage / (coverage + 2.5 * radiance.r * frame.exposure * (1.0 - coverage) + 1e-6);
  radiance *= isCovered ? vec3(1.0) : shown * vec3(1.0, 1.15, 1.3);
  depth *= shown;  // so that light for each alpha stays a flame's: displayedColor of lib/lone-display.glsl
#endif
  // The largest half float is 65504: a small flame comes near it, and clipping by channel would turn it green. Of a radiance
  // r at most 1 - r / 6e4 of what is behind passes, so that flames behind one another stay below 6e4.
  float peak = max(radiance.r, max(radiance.g, radiance.b));
  radiance *= min(1.0, 3e4 / max(peak, 1e-6));
  oRadiance = vec4(radiance, max(1.0 - exp(-depth), min(peak, 3e4) / 6e4));
}
