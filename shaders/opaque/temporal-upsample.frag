#version 300 es
// Temporal upsampling: a reduced frame, and what frames before it accumulated -> display colour at the canvas's size.
// In:  display colour at the reduced resolution; motion; history buffer.   Out: display colour.
// After Karis 2014, "High Quality Temporal Supersampling", and Yang, Liu and Salvi 2020, "A Survey of Temporal Antialiasing
// Techniques", 4.
#include "lib/precision.glsl"

uniform sampler2D uSource;   // display colour, nearest texel
uniform sampler2D uSmooth;   // the same, bilinear
uniform sampler2D uMotion;   // nearest texel
uniform sampler2D uHistory;
uniform vec2 uSampleOffset;  // from a texel's center to its sample, unless it is held, uv
uniform float uShare;        // of the frame in a pixel; 1 without a history

in vec2 vUv;

out vec4 oColor;

// Of the taps around a pixel at an edge, texels.
const float TAP_DISTANCE = 0.5;
// Share of the frame for each unit of colour, summed over channels, that the history is outside its bounds.
const float REJECTION = 2.0;

void main() {
  vec4 motion = texture(uMotion, vUv);
  vec2 size = vec2(textureSize(uSource, 0));
  vec2 place = (vUv - uSampleOffset * (1.0 - motion.a)) * size - 0.5;
  // A pixel at a sample is in the same square of four on all drivers.
  vec2 corner = floor(place + 0.01);
  vec2 part = place - corner;
  vec2 low = (corner + 0.5) / size;
  vec2 high = (corner + 1.5) / size;
  vec3 a = texture(uSource, low).rgb;
  vec3 b = texture(uSource, vec2(high.x, low.y)).rgb;
  vec3 c = texture(uSource, vec2(low.x, high.y)).rgb;
  vec3 d = texture(uSource, high).rgb;
  vec3 current = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
  // Without other samples edges are smoothed: in a frame without a history, and of what is held, which has the same samples
  // in each. Software renderers execute both sides of an `if`, but skip a loop that no pixel enters.
  for (float edge = max(motion.z, step(1.0, uShare)); edge > 0.0; edge = 0.0) {
    vec2 at = (place + 0.5) / size;
    vec2 tap = TAP_DISTANCE / size;
    vec3 sum = textureLod(uSmooth, at + tap, 0.0).rgb + textureLod(uSmooth, at - tap, 0.0).rgb;
    tap.x = -tap.x;
    sum += textureLod(uSmooth, at + tap, 0.0).rgb + textureLod(uSmooth, at - tap, 0.0).rgb;
    current = mix(current, 0.25 * sum, edge);
  }
  vec3 history = texture(uHistory, vUv + motion.xy).rgb;
  vec3 bounded = clamp(history, min(min(a, b), min(c, d)), max(max(a, b), max(c, d)));
  // A colour that lies far outside was of another surface.
  float rejected = min(REJECTION * dot(abs(history - bounded), vec3(1.0)), 1.0);
  oColor = vec4(mix(bounded, current, max(uShare, rejected)), 1.0);
}
