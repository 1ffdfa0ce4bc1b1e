#version 300 es
// Light of an upright flame that a rough mirror reflects, over that of the flame's points: by distance along x, from 5 cm
// to 2.5 m, roughness along y, from 0.05 to 0.45.
// Out: the share by a floor, the flame 45 degrees high; by a wall, the flame 60 degrees aside; the brightest mirror image
// of both, over the flame. In every other row the flame is 8 and 20 degrees beside the floor's normal, and the last is how
// bright the image of a flame without length is.
#include "lib/precision.glsl"
#include "lib/flame-brdf.glsl"

in vec2 vUv;

out vec4 oShares;

const vec3 HALF_AXIS = vec3(0.0, 0.0095, 0.0);
const float RADIUS = 0.0028;
const int RAYS = 96;           // a side
const ivec2 POINTS = ivec2(5, 15);  // across the flame, and along it

// The share, and the brightest image.
vec2 energy(vec3 normal, vec3 L, float reach, float alpha) {
  vec3 toLight = reach * L;
  vec3 mirrored = reflect(-L, normal);
  vec3 aside = normalize(cross(mirrored, vec3(0.6, 0.0, 0.8)));
  vec3 side = normalize(cross(HALF_AXIS, toLight)) * RADIUS;
  float extent = min(1.5, 20.0 * (alpha + HALF_AXIS.y / reach));
  vec2 sums = vec2(0.0);
  float brightest = 0.0;
  for (int i = 0; i < RAYS * RAYS; i++) {
    // Closer together beside the mirrored ray.
    vec2 at = (vec2(i % RAYS, i / RAYS) + 0.5) / float(RAYS) * 2.0 - 1.0;
    vec2 angle = extent * at * at * at;
    vec2 slope = tan(angle);
    vec3 view = mirrored + aside * slope.x + cross(mirrored, aside) * slope.y;
    float squared = dot(view, view);
    view *= inversesqrt(squared);
    float NoV = dot(normal, view);
    if (NoV < 1e-3) continue;
    vec2 secant = 1.0 / cos(angle);
    float weight = at.x * at.x * at.y * at.y * secant.x * secant.x * secant.y * secant.y * NoV / (squared * sqrt(squared));
    float lobe = flameSpecular(toLight, HALF_AXIS, RADIUS, normal, view, NoV, alpha).lobe / (reach * reach);
    brightest = max(brightest, lobe);
    float exact = 0.0;
    for (int j = 0; j < POINTS.x * POINTS.y; j++) {
      vec2 place = (vec2(j % POINTS.x, j / POINTS.x) + 0.5) / vec2(POINTS) * 2.0 - 1.0;
      vec3 to = toLight + 0.8 * side * place.x + HALF_AXIS * place.y;
      vec3 S = normalize(to);
      float NoS = max(dot(normal, S), 0.0);
      float NoH = max(dot(normal, normalize(S + view)), 0.0);
      exact += distributionGgx(alpha, NoH) * visibilitySmith(alpha, NoV, NoS) * NoS / dot(to, to);
    }
    sums += weight * vec2(lobe, exact / float(POINTS.x * POINTS.y));
  }
  return vec2(sums.x / sums.y, brightest * 4.0 * length(cross(HALF_AXIS, L)) * RADIUS);
}

void main() {
  float reach = 0.05 * pow(50.0, vUv.x);
  float roughness = 0.05 + 0.4 * vUv.y;
  float alpha = roughness * roughness;
  const vec3 UP = vec3(0.0, 1.0, 0.0);
  if (int(gl_FragCoord.y) % 2 == 1) {
    vec2 above = energy(UP, vec3(0.139, 0.99, 0.0), reach, alpha);
    vec2 aside = energy(UP, vec3(0.342, 0.94, 0.0), reach, alpha);
    float small = flameSpecular(vec3(reach, reach, 0.0), vec3(0.0), RADIUS, UP, vec3(-0.707, 0.707, 0.0), 0.707, alpha).lobe;
    oShares = vec4(above.x, aside.x, small * RADIUS * RADIUS / (reach * reach), 1.0);
    return;
  }
  vec2 onFloor = energy(UP, normalize(vec3(1.0, 1.0, 0.0)), reach, alpha);
  vec2 onWall = energy(vec3(0.0, 0.0, 1.0), vec3(0.866, 0.0, 0.5), reach, alpha);
  oShares = vec4(onFloor.x, onWall.x, max(onFloor.y, onWall.y), 1.0);
}
