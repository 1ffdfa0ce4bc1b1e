#version 300 es
// Inspection: a pass's result in place of the frame.
// In:  the passes' textures.   Out: display colour.
#include "lib/precision.glsl"
#include "lib/frame.glsl"
#include "lib/photometry.glsl"
#include "lib/srgb.glsl"
#include "lib/depth.glsl"
#include "lib/flame-light.glsl"
#include "lib/irradiance-volume.glsl"
#include "lib/shadow-cube.glsl"

// VIEWS of src/render/post/inspect-pass.ts.
const int RADIANCE = 0;
const int EXPOSURE = 1;
const int BLOOM = 2;
const int DEPTH = 3;
const int SHADOW_CUBE = 4;
const int VOLUME = 5;
const int FLAME = 6;
const int TEMPERATURE = 7;

const float FARTHEST = 10.0;  // m
const float MIDDLE_GREY = 0.18;

uniform sampler2D uRadiance;
uniform sampler2D uBloom;
uniform vec3 uAdaptation;
uniform int uView;
uniform float uWhiteLuminance;  // for FLAME, cd/m²

in vec2 vUv;
flat in float vExposure;

out vec4 oColor;

// Heat map, from black by blue, green and yellow to white.
vec3 falseColor(float share) {
  const vec3 COLORS[6] = vec3[6](vec3(0.0), vec3(0.1, 0.15, 0.7), vec3(0.0, 0.6, 0.45),
    vec3(0.85, 0.75, 0.1), vec3(0.95, 0.3, 0.1), vec3(1.0));
  float position = clamp(share, 0.0, 0.999) * 5.0;
  int first = int(position);
  return mix(COLORS[first], COLORS[first + 1], position - float(first));
}

// Grey by distance, black at the farthest.
vec3 distanceGrey(float distance) {
  return vec3(1.0 - sqrt(min(distance / FARTHEST, 1.0)));
}

// Zone system, a stop to a zone. Adams 1948, "The Negative".
vec3 zone(float luminance) {
  float stops = log2(max(luminance * vExposure / MIDDLE_GREY, 1e-9));
  if (stops > 5.0) return vec3(0.9, 0.15, 0.1);
  if (stops < -6.0) return vec3(0.05, 0.1, 0.45);
  return vec3((floor(stops) + 6.5) / 11.5);
}

// Heat map from dark red to white, 1400 to 2000 K. The ratio of green to red in soot's light is linear in temperature.
vec3 temperatureColor(vec3 soot) {
  if (soot.r < 1.0) return vec3(0.0);
  float kelvin = 1000.0 + (soot.g / soot.r - 0.0191) * 3540.0;
  float share = clamp((kelvin - 1400.0) / 600.0, 0.0, 1.0);
  return clamp(vec3(0.25, 0.0, 0.0) + vec3(1.5, 1.0, 1.0) * (vec3(share) - vec3(0.0, 0.35, 0.7)) * vec3(1.0, 1.6, 3.4), 0.0, 1.0);
}

// Direction at a pixel of a cube map unfolded to a cross; 0 outside of it.
vec3 cubeCrossDirection(vec2 pixel) {
  float edge = min(frame.viewport.x / 4.0, frame.viewport.y / 3.0);
  vec2 onCross = (pixel - 0.5 * frame.viewport) / edge + vec2(2.0, 1.5);
  vec2 cell = floor(onCross);
  vec2 p = (onCross - cell) * 2.0 - 1.0;
  if (cell.x < 0.0 || cell.x > 3.0 || cell.y < 0.0 || cell.y > 2.0) return vec3(0.0);
  if (cell.y == 1.0) {
    if (cell.x == 0.0) return vec3(-1.0, p.y, -p.x);
    if (cell.x == 1.0) return vec3(p.x, p.y, -1.0);
    return cell.x == 2.0 ? vec3(1.0, p.y, p.x) : vec3(-p.x, p.y, 1.0);
  }
  if (cell.x != 1.0) return vec3(0.0);
  return cell.y > 1.0 ? vec3(p.x, 1.0, p.y) : vec3(p.x, -1.0, -p.y);
}

vec3 shadowCube() {
  vec3 direction = cubeCrossDirection(gl_FragCoord.xy);
  if (direction == vec3(0.0)) return direction;
  return distanceGrey(casterDistance(direction) * length(direction));
}

// The irradiance atlas in a band across the frame: its planes, which lie one above another, side by side.
vec3 irradianceAtlas() {
  float edge = frame.viewport.x / (volume.columns * volume.planes);
  float up = (gl_FragCoord.y - 0.5 * frame.viewport.y) / (edge * volume.rows) + 0.5;
  if (up < 0.0 || up > 1.0) return vec3(0.0);
  float across = vUv.x * volume.planes;
  float plane = min(floor(across), volume.planes - 1.0);
  return texture(uIrradiance, vec2(across - plane, (plane + up) / volume.planes)).rgb * light.intensity / PI;
}

vec3 toneMapped(vec3 radiance) {
  return encodeSrgb(compressHighlights(radiance * uAdaptation * vExposure));
}

vec3 viewColor() {
  vec3 radiance = texture(uRadiance, vUv).rgb;
  if (uView == RADIANCE) return falseColor((log2(max(luma(radiance), 1e-9)) + 10.0) / 24.0);
  if (uView == EXPOSURE) return zone(luma(radiance));
  if (uView == BLOOM) return toneMapped(texture(uBloom, vUv).rgb);
  if (uView == DEPTH) return distanceGrey(linearDepth(texture(uDepth, vUv).r));
  if (uView == SHADOW_CUBE) return shadowCube();
  if (uView == VOLUME) return toneMapped(irradianceAtlas());
  if (uView == FLAME) return encodeSrgb(compressHighlights(radiance * uAdaptation / uWhiteLuminance));
  if (uView == TEMPERATURE) return temperatureColor(radiance);
  return radiance;
}

void main() {
  oColor = vec4(clamp(viewColor(), 0.0, 1.0), 1.0);
}
