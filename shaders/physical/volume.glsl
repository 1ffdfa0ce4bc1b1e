// Light that comes from the room's surfaces, at every place, for 1 cd of the flame's: radiance in spherical harmonics of
// degree 1, three textures, one for each channel, (mean, x, y, z) in each texel.
// A grid of probes, flattened: planes of constant z lie side by side along x.

layout(std140) uniform Volume {
  vec3 corner;    // of the room, m
  float planes;   // probes along z
  vec3 extent;    // of the room, m
  float columns;  // probes along x
  float rows;     // probes along y
} volume;

uniform sampler2D uVolumeRed;
uniform sampler2D uVolumeGreen;
uniform sampler2D uVolumeBlue;

// Green 2003, "Spherical Harmonic Lighting: The Gritty Details": the first two bands.
const float Y0 = 0.282095;
const float Y1 = 0.488603;

// Ramamoorthi and Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps":
// a cosine lobe keeps pi of the mean and 2 pi / 3 of the slope.
float irradianceOf(vec4 harmonics, vec3 normal) {
  return max(PI * Y0 * harmonics.x + (2.0 * PI / 3.0) * Y1 * dot(harmonics.yzw, normal), 0.0);
}

// Radiance from all around a place, in spherical harmonics for each channel.
struct Surroundings {
  vec4 red;
  vec4 green;
  vec4 blue;
};

// For 1 cd of the flame's.
Surroundings surroundingsAt(vec3 position) {
  vec3 count = vec3(volume.columns, volume.rows, volume.planes);
  vec3 place = (position - volume.corner) / volume.extent * count;
  vec2 inPlane = clamp(place.xy, vec2(0.5), count.xy - 0.5);
  float depth = clamp(place.z - 0.5, 0.0, count.z - 1.001);
  float plane = floor(depth);
  vec2 near = vec2((plane * count.x + inPlane.x) / (count.x * count.z), inPlane.y / count.y);
  vec2 far = near + vec2(1.0 / count.z, 0.0);
  float share = depth - plane;
  return Surroundings(
    mix(textureLod(uVolumeRed, near, 0.0), textureLod(uVolumeRed, far, 0.0), share),
    mix(textureLod(uVolumeGreen, near, 0.0), textureLod(uVolumeGreen, far, 0.0), share),
    mix(textureLod(uVolumeBlue, near, 0.0), textureLod(uVolumeBlue, far, 0.0), share)
  );
}

vec3 irradianceFrom(Surroundings surroundings, vec3 normal) {
  return vec3(
    irradianceOf(surroundings.red, normal),
    irradianceOf(surroundings.green, normal),
    irradianceOf(surroundings.blue, normal)
  );
}
