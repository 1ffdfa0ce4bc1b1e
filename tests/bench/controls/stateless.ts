import { type Cell, FRAME } from "../law.js";
import type { Peer } from "../peer.js";
import { contextOf, HEADER, link, prepare, SPRITE } from "./raw.js";

// Drift is a random walk, which has no closed form: a steady push takes its place, as wide after a life.
const DRAW = `${HEADER}
const float PUSH = 0.2 * DRIFT;
uniform float uTime;
uniform float uCount;
void main() {
  float lives = uTime / LIFE + float(gl_VertexID) / uCount;
  float generation = floor(lives);
  float share = lives - generation;
  float age = share * LIFE;
  uint hash = pcg(uint(gl_VertexID) + pcg(uint(generation)));
  uint hash2 = pcg(hash);
  uint hash3 = pcg(hash2);
  uint hash4 = pcg(hash3);
  uint hash5 = pcg(hash4);
  uint hash6 = pcg(hash5);
  vec3 birth = SPAWN_RADIUS * vec3(signedUnit(hash), 0.0, signedUnit(hash2));
  vec3 velocity = vec3(SIDE_SPEED * signedUnit(hash3), mix(SLOWEST, FASTEST, unit(hash4)), SIDE_SPEED * signedUnit(hash5));
  vec3 acceleration = vec3(PUSH * signedUnit(hash6), BUOYANCY, PUSH * signedUnit(pcg(hash6)));
  show(birth + (velocity + 0.5 * acceleration * age) * age, 1.0 - share);
}`;

/** The least there can be: where a particle is follows from its number and the time. */
export function stateless(canvas: HTMLCanvasElement, { count, pixels }: Cell): Peer {
  const gl = contextOf(canvas);
  const draw = link(gl, DRAW, SPRITE);
  const uGlow = prepare(gl, draw, pixels);
  gl.uniform1f(gl.getUniformLocation(draw, "uCount"), count);
  const uTime = gl.getUniformLocation(draw, "uTime");
  let frame = 0;
  return {
    name: "stateless",
    gl,
    glow: [1, 1, 1],
    frame() {
      gl.depthMask(true);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.depthMask(false);
      gl.uniform1f(uTime, frame++ * FRAME);
      gl.uniform3fv(uGlow, this.glow);
      gl.drawArrays(gl.POINTS, 0, count);
    },
    dispose: () => gl.getExtension("WEBGL_lose_context")?.loseContext(),
  };
}
