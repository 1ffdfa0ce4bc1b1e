#version 300 es
// What each probe gets of the light that bounces for the first time: all patches that the flame sees, as
// far as the probe sees them.
// Out: three coefficients of radiance.
#include "lib/precision.glsl"
#include "lib/octahedral.glsl"
#include "lib/photometry.glsl"
#include "physical/harmonics.glsl"
#include "physical/light.glsl"
#include "physical/volume.glsl"
#include "physical/surfels.glsl"

uniform sampler2D uRadiosity;

// A patch may lie so much farther than what is seen its way: a share of the distance, and metres. More would
// let light pass by edges, where a probe sees what is near and what is far at once; but where probes are so few
// that they do not look around, they see edges nearly everywhere.
const float SLANT = 0.05;
const float THICK = 0.05;

layout(location = 0) out vec4 oFirst;
layout(location = 1) out vec4 oSecond;
layout(location = 2) out vec4 oThird;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 tile = ivec2(texel.x / TILE, texel.y);
  int k = texel.x - tile.x * TILE;
  vec3 position = texelFetch(uProbes, tile, 0).xyz;
  int size = textureSize(uNormalDistance, 0).y;
  vec3 first = vec3(0.0);
  vec3 second = vec3(0.0);
  vec3 third = vec3(0.0);
  for (int y = 0; y < size; y++) {
    for (int x = 0; x < FACE_COUNT * size; x++) {
      Surfel surfel = surfelAt(ivec2(x, y), size);
      vec3 toward = surfel.position - position;
      float distanceSquared = max(dot(toward, toward), 1e-6);
      float reach = sqrt(distanceSquared);
      vec3 direction = toward / reach;
      float facing = dot(surfel.normal, -direction);
      if (facing <= 0.0 || surfel.distance <= 0.0) continue;
      // A disc, not a point: near by it fills half of the view, and no more.
      float solidAngle = facing * surfel.area / (distanceSquared + surfel.area / PI);
      // A patch is as far as what it is part of, give or take how much that slants.
      vec2 sight = sightOf(tile, direction);
      bool looks = volume.looks > 0.5;
      float slack = looks ? min(sight.g, SLANT * reach) + THICK : sight.g + 2.0 * THICK;
      float seen = inSight(sight, reach - slack);
      seen = looks ? seen : seen * seen * seen;
      vec3 light = texelFetch(uRadiosity, ivec2(x, y), 0).rgb * (solidAngle * seen / PI);
      first += harmonic(k, direction) * light;
      second += harmonic(k + 3, direction) * light;
      third += harmonic(k + 6, direction) * light;
    }
  }
  oFirst = vec4(first, 1.0);
  oSecond = vec4(second, 1.0);
  oThird = vec4(third, 1.0);
}
