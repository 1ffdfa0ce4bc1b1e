#version 300 es
// Smoke as streaklines: each a camera-facing ribbon, as wide as the line has diffused.
// REACH: half width of a ribbon, in standard deviations; less where the line is faint at its centre, down to an optical depth
// of FAINT, which nobody sees. LEAST_SINE: of the angle to the view ray.
// ALONE: over a page, where there is no room, and the smoke ends before the edges of the canvas.
// In:  parcels, a row for each moment of their birth, two texels each.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/candle-flames.glsl"
#ifdef ALONE
#include "lib/studio.glsl"
#else
#include "lib/flame-light.glsl"
#include "lib/irradiance-volume.glsl"
#endif
#include "lib/scattering.glsl"

// Least standard deviation, pixels: a narrower line is drawn fainter instead.
const float LEAST_WIDTH = 0.55;

uniform sampler2D uParcels;   // position, m; extinction's cross-section per metre, m | standard deviation, m
uniform sampler2D uSections;  // ends of the pieces of each line: rows from the youngest
uniform int uNewest;          // row of the youngest
uniform int uCount;           // rows
uniform vec3 uMoved;          // way of the wick since the youngest were born, m
#ifndef ALONE
uniform float uShare;         // of the carried flame's light
#endif

out vec3 vRadiance;
out float vOpticalDepth;  // through the centre of the line
out float vAcross;        // from the centre, in standard deviations

vec4 parcel(int age, int line) {
  int young = clamp(age, 0, uCount - 1);
  vec4 texel = texelFetch(uParcels, ivec2(2 * line, (uNewest - young + ROWS) % ROWS), 0);
  // The thread begins at the wick, which has moved on since the air's last step.
  texel.xyz += uMoved * max(0.0, 1.0 - float(young) / float(LED_ROWS));
  return texel;
}

float breadth(int age, int line) {
  return texelFetch(uParcels, ivec2(2 * line + 1, (uNewest - min(age, uCount - 1) + ROWS) % ROWS), 0).x;
}

// Cubic Hermite curve between two parcels.
struct Curve {
  vec3 begin;
  vec3 end;
  vec3 beginTangent;
  vec3 endTangent;
};

// Direction of a line at the middle one of three places: the tangent of the circle through them.
vec3 direction(vec3 before, vec3 here, vec3 after) {
  vec3 a = here - before;
  vec3 b = after - here;
  float lengthA = max(length(a), 1e-7);
  float lengthB = max(length(b), 1e-7);
  return normalize(a * (lengthB / lengthA) + b * (lengthA / lengthB) + vec3(0.0, 1e-12, 0.0));
}

vec3 place(Curve curve, float t) {
  float s = 1.0 - t;
  return (1.0 + 2.0 * t) * s * s * curve.begin + (3.0 - 2.0 * t) * t * t * curve.end +
    t * s * (s * curve.beginTangent - t * curve.endTangent);
}

vec3 along(Curve curve, float t) {
  return 6.0 * t * (1.0 - t) * (curve.end - curve.begin) + (1.0 - t) * (1.0 - 3.0 * t) * curve.beginTangent +
    t * (3.0 * t - 2.0) * curve.endTangent;
}

// Across the line and the view ray; its length is the sine between them.
vec3 acrossLine(Curve curve, float t) {
  return cross(normalize(along(curve, t) + vec3(0.0, 1e-9, 0.0)), normalize(frame.eyePosition - place(curve, t)));
}

// Radiance of optically thick smoke in the light of all flames, cd/m².
vec3 smokeRadiance(vec3 position) {
  vec3 direct = vec3(0.0);
  for (int i = 0; i < int(flames.count); i++) {
    direct += scatteredDirect(flames.intensities[i].rgb, flames.centres[i].xyz - position, frame.eyePosition - position);
  }
#ifdef ALONE
  vec3 ambient = 0.5 * (environment(vec3(0.0, 1.0, 0.0)) + environment(vec3(0.0, -1.0, 0.0)));
  return DROPLET_ALBEDO * (direct + ambient);
#else
  return DROPLET_ALBEDO * direct + scatteredRadiance(position, frame.eyePosition, uShare);
#endif
}

void main() {
  int side = gl_VertexID & 1;
  int end = (gl_VertexID >> 1) & 1;
  int line = (gl_VertexID >> 2) % LINES;
  int piece = (gl_VertexID >> 2) / LINES;
  float begins = texelFetch(uSections, ivec2(piece, 0), 0).x;
  int age = int(begins);
  begins -= float(age);
  float t = end == 0 ? begins : texelFetch(uSections, ivec2(piece + 1, 0), 0).x - float(age);
  vec4 young = parcel(age, line);
  vec4 old = parcel(age + 1, line);
  float apart = distance(young.xyz, old.xyz);
  vec3 beginTangent = apart * direction(parcel(age - 1, line).xyz, young.xyz, old.xyz);
  vec3 endTangent = apart * direction(young.xyz, old.xyz, parcel(age + 2, line).xyz);
  Curve curve = Curve(young.xyz, old.xyz, beginTangent, endTangent);
  vec3 here = place(curve, t);
  vec3 toEye = frame.eyePosition - here;
  float distance = max(length(toEye), 0.02);
  vec3 sideways = acrossLine(curve, t);
  // Where the line folds, or passes the view ray, the ends of a piece have opposite sides: the piece would cross itself.
  if (end == 1 && dot(sideways, acrossLine(curve, begins)) < 0.0) sideways = -sideways;
  float sine = length(sideways);
  float width = mix(breadth(age, line), breadth(age + 1, line), t);
  float drawnWidth = max(width, LEAST_WIDTH * distance / frame.projectionScale);
  // A line nearly parallel to the view ray has a longer path through it.
  vOpticalDepth = mix(young.w, old.w, t) / (drawnWidth * sqrt(2.0 * PI) * max(sine, LEAST_SINE));
  vRadiance = smokeRadiance(here);
  float reach = min(sqrt(2.0 * log(max(vOpticalDepth / FAINT, 1.0))), REACH);
  vAcross = (float(side) * 2.0 - 1.0) * reach;
  vec3 position = here + sideways / max(sine, 1e-4) * (vAcross * drawnWidth);
  gl_Position = frame.clipFromWorld * vec4(position, 1.0);
#ifdef ALONE
  vec2 uv = 0.5 + 0.5 * gl_Position.xy / gl_Position.w;
  vec2 margin = smoothstep(vec2(0.0), vec2(0.12), min(uv, 1.0 - uv));
  vOpticalDepth *= margin.x * margin.y;
#endif
}
