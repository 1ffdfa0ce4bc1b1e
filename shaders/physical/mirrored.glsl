// The room in a smooth surface.
// Needs lib/photometry.glsl, physical/light.glsl, physical/soft-shadow.glsl, physical/surfels.glsl.
//
// Whatever the flame lights is in its sight: the cube of distances from it is the shape of all that is bright,
// so a mirrored ray is followed through that cube until it falls behind what the flame sees there.
// After Szirmay-Kalos, Aszódi, Lazányi and Premecz 2005, "Approximate Ray-Tracing on the GPU with Distance Impostors".

uniform sampler2D uRadiosity;  // of the patches that the flame sees, lm/m²

// The ray is looked at from the first of these distances to the last, each so many times the one before. Metres.
const float FIRST_LOOK = 0.04;
const float LAST_LOOK = 9.0;
const float NEXT_LOOK = 1.25;
const int HALVINGS = 6;
// What is known of distances in steps of so much, m, is no edge.
const float STEP = 0.02;
// What lies less deep than this behind an edge, m, was met there; what lies deeper than that was passed.
const vec2 MET = vec2(0.06, 0.25);

// How far a place, m from the vantage, is behind what the flame sees in its direction, m.
float behindSeen(vec3 fromVantage) {
  return length(fromVantage) - textureLod(uShadow, fromVantage, 0.0).r - STEP;
}

// What the patches around a direction from the flame send back, mixed: of one face.
vec3 sentBackFrom(vec3 fromVantage) {
  int size = textureSize(uRadiosity, 0).y;
  vec3 place = placeOnFaces(fromVantage);
  vec2 at = clamp(place.xy * float(size) - 0.5, vec2(0.0), vec2(float(size) - 1.0));
  ivec2 corner = min(ivec2(at), size - 2);
  vec2 share = at - vec2(corner);
  corner.x += int(place.z) * size;
  vec3 low = mix(texelFetch(uRadiosity, corner, 0).rgb, texelFetch(uRadiosity, corner + ivec2(1, 0), 0).rgb, share.x);
  vec3 high = mix(texelFetch(uRadiosity, corner + ivec2(0, 1), 0).rgb, texelFetch(uRadiosity, corner + 1, 0).rgb, share.x);
  return mix(low, high, share.y);
}

// Radiance of the flame's own light where a ray ends, cd/m² for 1 cd; black where the flame sees nothing of it.
vec3 mirroredLight(vec3 position, vec3 ray) {
  vec3 start = position - light.vantage;
  float near = FIRST_LOOK;
  bool wasBehind = behindSeen(start + ray * near) > 0.0;
  vec3 sum = vec3(0.0);
  float left = 1.0;
  for (float far = FIRST_LOOK * NEXT_LOOK; far < LAST_LOOK && left > 0.01; far *= NEXT_LOOK) {
    bool isBehind = behindSeen(start + ray * far) > 0.0;
    if (isBehind != wasBehind) {
      float low = near;
      float high = far;
      for (int i = 0; i < HALVINGS; i++) {
        float middle = 0.5 * (low + high);
        if (behindSeen(start + ray * middle) > 0.0 == isBehind) high = middle;
        else low = middle;
      }
      vec3 end = start + ray * (isBehind ? high : low);
      float met = left * (1.0 - smoothstep(MET.x, MET.y, behindSeen(end)));
      // Who comes out of a shadow through what throws it meets its dark side.
      if (isBehind) sum += met * sentBackFrom(end);
      left -= met;
    }
    wasBehind = isBehind;
    near = far;
  }
  return sum / PI;
}
