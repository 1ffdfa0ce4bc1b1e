#version 300 es
// Smoke as streaklines: each a camera-facing ribbon, as wide as the line has diffused.
// In:  parcels, a row for each moment of their birth, two texels each.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "lib/flame-light.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/scattering.glsl"

// Half width of the ribbon, in standard deviations of the line.
const float REACH = 2.4;
// Least standard deviation, pixels: a narrower line is drawn fainter instead.
const float LEAST_WIDTH = 0.55;

uniform sampler2D uParcels;  // position, m; extinction's cross-section per metre, m | standard deviation, m
uniform int uNewest;         // row of the youngest
uniform int uCount;          // rows

out vec3 vRadiance;
out float vOpticalDepth;  // through the centre of the line
out float vAcross;        // from the centre, in standard deviations

vec4 parcel(int age, int line) {
  int row = (uNewest - clamp(age, 0, uCount - 1) + ROWS) % ROWS;
  return texelFetch(uParcels, ivec2(2 * line, row), 0);
}

void main() {
  int side = gl_VertexID & 1;
  int line = (gl_VertexID >> 1) % LINES;
  int age = (gl_VertexID >> 1) / LINES;
  vec4 here = parcel(age, line);
  float width = texelFetch(uParcels, ivec2(2 * line + 1, (uNewest - age + ROWS) % ROWS), 0).x;
  vec3 toEye = frame.eyePosition - here.xyz;
  float distance = max(length(toEye), 0.02);
  vec3 along = parcel(age - 1, line).xyz - parcel(age + 1, line).xyz + vec3(0.0, 1e-6, 0.0);
  vec3 sideways = cross(normalize(along), toEye / distance);
  float sine = length(sideways);
  float drawnWidth = max(width, LEAST_WIDTH * distance / frame.projectionScale);
  // A line nearly parallel to the view ray has a longer path through it.
  vOpticalDepth = here.w / (drawnWidth * sqrt(2.0 * PI) * max(sine, 0.3));
  vRadiance = scatteredRadiance(here.xyz, frame.eyePosition);
  vAcross = (float(side) * 2.0 - 1.0) * REACH;
  vec3 position = here.xyz + sideways / max(sine, 1e-4) * (vAcross * drawnWidth);
  gl_Position = frame.clipFromWorld * vec4(position, 1.0);
}
