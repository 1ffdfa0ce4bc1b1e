// The particle kernel, one or two ticks in one pass: the law of src/world/particles/particles.ts, its twin.
// In:  one particle.   Out: the same particle later, captured by transform feedback.
// Lengths are in the emitter's own unit, positions relative to the emitter.
//
// A CPU that plays the GPU runs both sides of every branch, and checks bounds at every read of an
// array. So a newborn is made once a pass, ticks are no loop, and the dead move on unseen.
#include "lib/precision.glsl"
#include "lib/random.glsl"

const int MAX_TICKS = 2;
const uint GROUPS = 4u;
const uint NEVER = 0xffffffffu;

layout(location = 0) in vec4 aPositionLife;  // life: seconds left
layout(location = 1) in vec4 aVelocitySpan;  // span: life at birth, s

out vec4 vPositionLife;
out vec4 vVelocitySpan;

layout(std140) uniform Layer {
  float tick;         // s
  float interval;     // s from birth to birth
  float life;         // s, more than MAX_TICKS ticks
  float spawnRadius;
  float spawnHeight;
  float spawnDepth;   // most that a birth is above or below it
  float sideSpeed;
  float slowest;      // 1/s
  float fastest;
  float lift;         // speed gained by buoyancy in a tick
  float push;         // most speed gained by drift in a tick
  float kept;         // share of the velocity that the wind leaves in a tick
} layer;

uniform int uTicks;
uniform uint uGroupSize;          // slots of a group
uniform uint uGroups;             // groups that bear
uniform uint uFirstTurn;          // turn of the first birth of the pass
uniform uint uFirstKey;           // its chances; the next birth's follow
uniform uint uBirths[MAX_TICKS];  // births in the tick
uniform float uEldest[MAX_TICKS]; // age of the first of them at its end, s
uniform uint uTickKeys[MAX_TICKS];
uniform vec3 uLeft[MAX_TICKS];    // the emitter's way, as far as particles stay behind
uniform vec2 uBlown[MAX_TICKS];   // velocity taken up from the wind

uint slot;
vec3 position;
vec3 velocity;
float remaining;

// What the slot bears next: which birth it is, from the first of the tick at hand, and its beginning.
uint birth;
vec3 birthplace;
vec3 launch;

uint birthOfSlot() {
  uint size = uGroupSize;
  uint group = uint(slot >= size) + uint(slot >= 2u * size) + uint(slot >= 3u * size);
  uint turn = (slot - group * size) * GROUPS + group;
  uint number = turn - uFirstTurn + (turn < uFirstTurn ? GROUPS * size : 0u);
  return group < uGroups ? number : NEVER;
}

void conceive() {
  birth = birthOfSlot();
  uint h0 = pcg(birth + uFirstKey);
  uint h1 = pcg(h0);
  vec2 place = layer.spawnRadius * signedHalves(h0);
  vec2 side = layer.sideSpeed * signedHalves(h1);
  uint h2 = pcg(h1);
  birthplace = vec3(place.x, layer.spawnHeight + layer.spawnDepth * signedHalves(h2).y, place.y);
  launch = vec3(side.x, mix(layer.slowest, layer.fastest, unit(h2)), side.y);
}

void advance(uint key, uint births, float eldest, vec3 left, vec2 blown) {
  vec2 drifted = velocity.xz + layer.push * signedHalves(pcg(slot + key));
  velocity = vec3(drifted * layer.kept + blown, velocity.y + layer.lift).xzy;
  position += velocity * layer.tick - left;
  remaining -= layer.tick;
  if (birth < births) {
    float age = eldest - float(birth) * layer.interval;
    position = birthplace + launch * age - left * (age / layer.tick);
    velocity = launch;
    remaining = layer.life - age;
  }
  birth -= births;  // what is born wraps to a birth that never comes
}

void moveParticle() {
  slot = uint(gl_VertexID);
  position = aPositionLife.xyz;
  velocity = aVelocitySpan.xyz;
  remaining = aPositionLife.w;
  conceive();
  advance(uTickKeys[0], uBirths[0], uEldest[0], uLeft[0], uBlown[0]);
  if (uTicks > 1) advance(uTickKeys[1], uBirths[1], uEldest[1], uLeft[1], uBlown[1]);
  vPositionLife = vec4(position, remaining);
  vVelocitySpan = vec4(velocity, layer.life);
}
