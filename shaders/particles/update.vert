#version 300 es
// The particle kernel, up to MAX_TICKS ticks in one pass: twin of src/world/particles.ts, line by line.
// In:  one particle.   Out: the same particle later, captured by transform feedback.
// Lengths are in the emitter's own unit, positions relative to the emitter.
#include "lib/precision.glsl"
#include "lib/random.glsl"

const int MAX_TICKS = 8;
const uint GROUPS = 4u;

layout(location = 0) in vec4 aPositionLife;  // life: seconds left
layout(location = 1) in vec4 aVelocitySpan;  // span: life at birth, s

out vec4 vPositionLife;
out vec4 vVelocitySpan;

layout(std140) uniform Layer {
  float tick;         // s
  float rate;         // births/s
  float spawnRadius;
  float spawnHeight;
  float slowest;      // 1/s
  float fastest;
  float sideSpeed;
  float buoyancy;     // 1/s²
  float drift;
  float dragged;      // share of the wind's velocity taken up in a tick
  float stays;        // 1: keeps its place in the room, 0: rides with the emitter
  float life;         // s
} layer;

uniform int uTicks;
uniform uint uCapacity;
uniform uint uKey;                // this layer's chances
uniform uint uTickKeys[MAX_TICKS];
uniform uvec4 uBirths[MAX_TICKS]; // slot of the first birth, its number, count, groups that bear
uniform vec4 uWay[MAX_TICKS];     // the emitter's way; w: age of the first-born, s
uniform vec4 uWind[MAX_TICKS];    // relative to the emitter

vec3 position;
float remaining;
vec3 velocity;

void bear(uint birth, float age) {
  uint h0 = pcg(birth + uKey);
  uint h1 = pcg(h0);
  uint h2 = pcg(h1);
  uint h3 = pcg(h2);
  uint h4 = pcg(h3);
  velocity = vec3(
    layer.sideSpeed * signedUnit(h2),
    layer.slowest + (layer.fastest - layer.slowest) * unit(h3),
    layer.sideSpeed * signedUnit(h4)
  );
  position = vec3(
    layer.spawnRadius * signedUnit(h0),
    layer.spawnHeight,
    layer.spawnRadius * signedUnit(h1)
  ) + velocity * age;
  remaining = layer.life - age;
}

void move(uint slot, int i) {
  uint hash = pcg(slot + uTickKeys[i]);
  velocity.x += layer.drift * layer.tick * signedUnit(hash);
  velocity.y += layer.buoyancy * layer.tick;
  velocity.z += layer.drift * layer.tick * signedUnit(pcg(hash));
  velocity.xz += (uWind[i].xz - velocity.xz) * layer.dragged;
  position += velocity * layer.tick - uWay[i].xyz * layer.stays;
  remaining -= layer.tick;
}

void main() {
  position = aPositionLife.xyz;
  remaining = aPositionLife.w;
  velocity = aVelocitySpan.xyz;
  uint slot = uint(gl_VertexID);
  uint groupSize = uCapacity / GROUPS;
  uint group = slot / groupSize;
  uint turn = (slot - group * groupSize) * GROUPS + group;
  for (int i = 0; i < uTicks; i++) {
    uint birth = (turn + uCapacity - uBirths[i].x) % uCapacity;
    if (birth < uBirths[i].z && group < uBirths[i].w) {
      bear(uBirths[i].y + birth, uWay[i].w - float(birth) / layer.rate);
    } else if (remaining > 0.0) {
      move(slot, i);
    }
  }
  vPositionLife = vec4(position, remaining);
  vVelocitySpan = vec4(velocity, layer.life);
}
