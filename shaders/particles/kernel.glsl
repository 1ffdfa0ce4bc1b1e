// Particle kernel: one or two ticks of a particle by transform feedback, as src/world/particles/particles.ts has
// them. Lengths are in the emitter's own unit, positions relative to the emitter.
//
// A software renderer executes both sides of every branch and checks the bounds of every array access. So a birth is
// computed once a pass, the ticks are unrolled, and dead particles are moved, too.
#include "lib/precision.glsl"
#include "lib/random.glsl"

const int MAX_TICKS = 2;
const uint GROUPS = 4u;
const uint NO_BIRTH = 0xffffffffu;

layout(location = 0) in vec4 aPositionLife;  // life: remaining, s
layout(location = 1) in vec4 aVelocitySpan;  // span: life at birth, s

out vec4 vPositionLife;
out vec4 vVelocitySpan;

layout(std140) uniform Layer {
  float tick;         // s
  float interval;     // s between births
  float life;         // s, more than MAX_TICKS ticks
  float spawnRadius;
  float spawnHeight;
  float spawnDepth;   // largest deviation from it
  float sideSpeed;
  float minSpeed;     // upwards, at birth, 1/s
  float maxSpeed;
  float buoyancy;     // speed gained in a tick
  float drift;        // largest random change of speed in a tick
  float damping;      // share of the velocity that drag leaves in a tick
} layer;

uniform int uTicks;
uniform uint uGroupSize;          // slots of a group
uniform uint uGroups;             // groups with births
uniform uint uFirstTurn;          // of the pass's first birth in the order of slots
uniform uint uFirstKey;           // seed of that birth; each next one adds 1
uniform uint uBirths[MAX_TICKS];  // births in the tick
uniform float uOldestAge[MAX_TICKS]; // of the first of them at the tick's end, s
uniform uint uTickKeys[MAX_TICKS];
uniform vec3 uDisplacement[MAX_TICKS]; // of the emitter, as far as particles do not follow it
uniform vec2 uWindVelocity[MAX_TICKS]; // velocity gained from the wind

uint slot;
vec3 position;
vec3 velocity;
float remaining;

// The slot's next birth: its number, counted from the first of the current tick, and the initial state.
uint birth;
vec3 birthPosition;
vec3 birthVelocity;

uint birthOfSlot() {
  uint size = uGroupSize;
  uint group = uint(slot >= size) + uint(slot >= 2u * size) + uint(slot >= 3u * size);
  uint turn = (slot - group * size) * GROUPS + group;
  uint number = turn - uFirstTurn + (turn < uFirstTurn ? GROUPS * size : 0u);
  return group < uGroups ? number : NO_BIRTH;
}

void prepareBirth() {
  birth = birthOfSlot();
  uint h0 = pcg(birth + uFirstKey);
  uint h1 = pcg(h0);
  vec2 offset = layer.spawnRadius * signedHalves(h0);
  vec2 side = layer.sideSpeed * signedHalves(h1);
  uint h2 = pcg(h1);
  birthPosition = vec3(offset.x, layer.spawnHeight + layer.spawnDepth * signedHalves(h2).y, offset.y);
  birthVelocity = vec3(side.x, mix(layer.minSpeed, layer.maxSpeed, unit(h2)), side.y);
}

void advance(uint key, uint births, float oldestAge, vec3 displacement, vec2 windVelocity) {
  vec2 drifted = velocity.xz + layer.drift * signedHalves(pcg(slot + key));
  velocity = vec3(drifted * layer.damping + windVelocity, velocity.y + layer.buoyancy).xzy;
  position += velocity * layer.tick - displacement;
  remaining -= layer.tick;
  if (birth < births) {
    float age = oldestAge - float(birth) * layer.interval;
    position = birthPosition + birthVelocity * age - displacement * (age / layer.tick);
    velocity = birthVelocity;
    remaining = layer.life - age;
  }
  birth -= births;  // a slot that was just filled wraps beyond every count
}

void moveParticle() {
  slot = uint(gl_VertexID);
  position = aPositionLife.xyz;
  velocity = aVelocitySpan.xyz;
  remaining = aPositionLife.w;
  prepareBirth();
  advance(uTickKeys[0], uBirths[0], uOldestAge[0], uDisplacement[0], uWindVelocity[0]);
  if (uTicks > 1) advance(uTickKeys[1], uBirths[1], uOldestAge[1], uDisplacement[1], uWindVelocity[1]);
  vPositionLife = vec4(position, remaining);
  vVelocitySpan = vec4(velocity, layer.life);
}
