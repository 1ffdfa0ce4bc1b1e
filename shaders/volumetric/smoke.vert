#version 300 es
// Smoke as streaklines: each a camera-facing ribbon, as wide as the line has diffused.
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

// Half width of the ribbon, in standard deviations of the line.
const float REACH = 2.4;
// Least standard deviation, pixels: a narrower line is drawn fainter instead.
const float LEAST_WIDTH = 0.55;

uniform sampler2D uParcels;  // position, m; extinction's cross-section per metre, m | standard deviation, m
uniform int uNewest;         // row of the youngest
uniform int uCount;          // rows
uniform vec3 uMoved;         // way of the wick since the youngest were born, m

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
  return DROPLET_ALBEDO * direct + scatteredRadiance(position, frame.eyePosition);
#endif
}

// Across the line and the view ray; its length is the sine between them.
vec3 acrossLine(int age, int line) {
  vec3 along = parcel(age - 1, line).xyz - parcel(age + 1, line).xyz + vec3(0.0, 1e-6, 0.0);
  return cross(normalize(along), normalize(frame.eyePosition - parcel(age, line).xyz));
}

void main() {
  int side = gl_VertexID & 1;
  int end = (gl_VertexID >> 1) & 1;
  int line = (gl_VertexID >> 2) % LINES;
  int young = (gl_VertexID >> 2) / LINES;
  int age = young + end;
  vec4 here = parcel(age, line);
  float width = texelFetch(uParcels, ivec2(2 * line + 1, (uNewest - age + ROWS) % ROWS), 0).x;
  vec3 toEye = frame.eyePosition - here.xyz;
  float distance = max(length(toEye), 0.02);
  vec3 sideways = acrossLine(age, line);
  // Where the line folds, or passes the view ray, the ends of a piece have opposite sides: the piece would cross itself.
  if (end == 1 && dot(sideways, acrossLine(young, line)) < 0.0) sideways = -sideways;
  float sine = length(sideways);
  float drawnWidth = max(width, LEAST_WIDTH * distance / frame.projectionScale);
  // A line nearly parallel to the view ray has a longer path through it.
  vOpticalDepth = here.w / (drawnWidth * sqrt(2.0 * PI) * max(sine, 0.3));
  vRadiance = smokeRadiance(here.xyz);
  vAcross = (float(side) * 2.0 - 1.0) * REACH;
  vec3 position = here.xyz + sideways / max(sine, 1e-4) * (vAcross * drawnWidth);
  gl_Position = frame.clipFromWorld * vec4(position, 1.0);
#ifdef ALONE
  vec2 uv = 0.5 + 0.5 * gl_Position.xy / gl_Position.w;
  vec2 margin = smoothstep(vec2(0.0), vec2(0.12), min(uv, 1.0 - uv));
  vOpticalDepth *= margin.x * margin.y;
#endif
}
