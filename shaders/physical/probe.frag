#version 300 es
// The light at each probe: all patches, as they look from there.
// Out: radiance in spherical harmonics of degree 1, a texture for each channel.
#include "lib/precision.glsl"
#include "lib/photometry.glsl"
#include "physical/light.glsl"
#include "physical/volume.glsl"
#include "physical/surfels.glsl"

uniform sampler2D uRadiosity;

layout(location = 0) out vec4 oRed;
layout(location = 1) out vec4 oGreen;
layout(location = 2) out vec4 oBlue;

void main() {
  vec2 texel = floor(gl_FragCoord.xy);
  float plane = floor(texel.x / volume.columns);
  vec3 cell = vec3(texel.x - plane * volume.columns, texel.y, plane) + 0.5;
  vec3 position = volume.corner + volume.extent * cell / vec3(volume.columns, volume.rows, volume.planes);
  int size = textureSize(uNormalDistance, 0).y;
  vec4 red = vec4(0.0);
  vec4 green = vec4(0.0);
  vec4 blue = vec4(0.0);
  for (int y = 0; y < size; y++) {
    for (int x = 0; x < FACE_COUNT * size; x++) {
      Surfel surfel = surfelAt(ivec2(x, y), size);
      vec3 toward = surfel.position - position;
      float distanceSquared = max(dot(toward, toward), 1e-6);
      vec3 direction = toward * inversesqrt(distanceSquared);
      float facing = max(dot(surfel.normal, -direction), 0.0);
      // A disc, not a point: near by it fills half of the view, and no more.
      float solidAngle = facing * surfel.area / (distanceSquared + surfel.area / PI);
      vec4 harmonics = vec4(Y0, Y1 * direction) * (solidAngle / PI);
      vec3 radiosity = texelFetch(uRadiosity, ivec2(x, y), 0).rgb;
      red += harmonics * radiosity.r;
      green += harmonics * radiosity.g;
      blue += harmonics * radiosity.b;
    }
  }
  oRed = red;
  oGreen = green;
  oBlue = blue;
}
