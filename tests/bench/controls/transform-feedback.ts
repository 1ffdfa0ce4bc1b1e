import { pcg, signed, unit } from "../../../src/world/random.js";
import { type Cell, FRAME, LAW } from "../law.js";
import type { Peer } from "../peer.js";
import { contextOf, HEADER, link, prepare, SPRITE } from "./raw.js";

const FLOATS = 8;
const STRIDE = FLOATS * 4;

const ATTRIBUTES = `
layout(location = 0) in vec4 aPositionLife;
layout(location = 1) in vec4 aVelocity;`;

const UPDATE = `${HEADER}
${ATTRIBUTES}
uniform float uSeconds;
uniform uint uFrame;
out vec4 vPositionLife;
out vec4 vVelocity;
void main() {
  vec3 position = aPositionLife.xyz;
  vec3 velocity = aVelocity.xyz;
  float life = aPositionLife.w - uSeconds;
  uint hash = pcg(uint(gl_VertexID) + uFrame);
  uint hash2 = pcg(hash);
  if (life <= 0.0) {
    uint hash3 = pcg(hash2);
    uint hash4 = pcg(hash3);
    uint hash5 = pcg(hash4);
    position = SPAWN_RADIUS * vec3(signedUnit(hash), 0.0, signedUnit(hash2));
    velocity = vec3(SIDE_SPEED * signedUnit(hash3), mix(SLOWEST, FASTEST, unit(hash4)), SIDE_SPEED * signedUnit(hash5));
    life += LIFE;
  } else {
    velocity += uSeconds * vec3(DRIFT * signedUnit(hash), BUOYANCY, DRIFT * signedUnit(hash2));
    position += velocity * uSeconds;
  }
  vPositionLife = vec4(position, life);
  vVelocity = vec4(velocity, 0.0);
}`;

const NOTHING = `#version 300 es
void main() {}`;

const DRAW = `${HEADER}
${ATTRIBUTES}
void main() {
  show(aPositionLife.xyz, aPositionLife.w / LIFE);
}`;

/** Particles of every age, so that the first frame is as full as any other. */
function population(count: number): Float32Array {
  const state = new Float32Array(count * FLOATS);
  const { spawnRadius, sideSpeed, speed, buoyancy, life } = LAW;
  for (let i = 0; i < count; i++) {
    const hashes = [pcg(i)];
    while (hashes.length < 5) hashes.push(pcg(hashes.at(-1) ?? 0));
    const [h0 = 0, h1 = 0, h2 = 0, h3 = 0, h4 = 0] = hashes;
    const age = (life * i) / count;
    const vx = sideSpeed * signed(h2);
    const vy = speed[0] + (speed[1] - speed[0]) * unit(h3);
    const vz = sideSpeed * signed(h4);
    const x = spawnRadius * signed(h0) + vx * age;
    const y = vy * age + (buoyancy / 2) * age * age;
    const z = spawnRadius * signed(h1) + vz * age;
    state.set([x, y, z, life - age, vx, vy + buoyancy * age, vz, 0], i * FLOATS);
  }
  return state;
}

/** The least that particles moved by transform feedback can be: one pass to move, one to draw. */
export function transformFeedback(canvas: HTMLCanvasElement, { count, pixels }: Cell): Peer {
  const gl = contextOf(canvas);
  const update = link(gl, UPDATE, NOTHING, ["vPositionLife", "vVelocity"]);
  const draw = link(gl, DRAW, SPRITE);
  const feedback = gl.createTransformFeedback();
  const half = (contents: Float32Array | number) => {
    const buffer = gl.createBuffer();
    const vertexArray = gl.createVertexArray();
    gl.bindVertexArray(vertexArray);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    if (typeof contents === "number") gl.bufferData(gl.ARRAY_BUFFER, contents, gl.DYNAMIC_COPY);
    else gl.bufferData(gl.ARRAY_BUFFER, contents, gl.DYNAMIC_COPY);
    for (const location of [0, 1]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 4, gl.FLOAT, false, STRIDE, location * 16);
    }
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return { buffer, vertexArray };
  };
  let now = half(population(count));
  let next = half(count * STRIDE);
  gl.useProgram(update);
  gl.uniform1f(gl.getUniformLocation(update, "uSeconds"), FRAME);
  const uFrame = gl.getUniformLocation(update, "uFrame");
  const uGlow = prepare(gl, draw, pixels);
  let frame = 0;
  return {
    name: "transform feedback",
    gl,
    glow: [1, 1, 1],
    frame() {
      gl.useProgram(update);
      gl.uniform1ui(uFrame, pcg(frame++));
      gl.bindVertexArray(now.vertexArray);
      gl.enable(gl.RASTERIZER_DISCARD);
      gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, next.buffer);
      gl.beginTransformFeedback(gl.POINTS);
      gl.drawArrays(gl.POINTS, 0, count);
      gl.endTransformFeedback();
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
      gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
      gl.disable(gl.RASTERIZER_DISCARD);
      [now, next] = [next, now];
      gl.depthMask(true);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.depthMask(false);
      gl.useProgram(draw);
      gl.uniform3fv(uGlow, this.glow);
      gl.bindVertexArray(now.vertexArray);
      gl.drawArrays(gl.POINTS, 0, count);
    },
    dispose: () => gl.getExtension("WEBGL_lose_context")?.loseContext(),
  };
}
