import { HEIGHT, LAW, sizeOf, VIEW, WIDTH } from "../law.js";

/** Jarzynski and Olano 2020, as everywhere in this project. */
const PCG = `
uint pcg(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}
float unit(uint hash) { return float(hash >> 8) / 16777216.0; }
float signedUnit(uint hash) { return unit(hash) * 2.0 - 1.0; }`;

const LAW_CONSTANTS = Object.entries({
  SPAWN_RADIUS: LAW.spawnRadius,
  SLOWEST: LAW.speed[0],
  FASTEST: LAW.speed[1],
  SIDE_SPEED: LAW.sideSpeed,
  BUOYANCY: LAW.buoyancy,
  DRIFT: LAW.drift,
  LIFE: LAW.life,
})
  .map(([name, value]) => `const float ${name} = float(${value});`)
  .join("\n");

/** What every vertex shader of the controls begins with. */
export const HEADER = `#version 300 es
precision highp float;
precision highp int;
${LAW_CONSTANTS}
${PCG}
uniform mat4 uClipFromWorld;
uniform float uPointScale;  // pixels of a new sprite at a distance of 1 m
flat out float vAlpha;
void show(vec3 position, float share) {
  vAlpha = share;
  gl_Position = uClipFromWorld * vec4(position, 1.0);
  gl_PointSize = uPointScale * share / gl_Position.w;
}`;

/** A round sprite of one colour with the paper's fall-off. */
export const SPRITE = `#version 300 es
precision highp float;
uniform vec3 uGlow;
flat in float vAlpha;
out vec4 oColor;
void main() {
  vec2 offset = gl_PointCoord * 2.0 - 1.0;
  float falloff = max(1.0 - dot(offset, offset), 0.0);
  oColor = vec4(uGlow * (falloff * falloff * vAlpha), 0.0);
}`;

export function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const gl = canvas.getContext("webgl2", { antialias: false, depth: true });
  if (!gl) throw new Error("This browser offers no WebGL 2.");
  return gl;
}

export function link(
  gl: WebGL2RenderingContext,
  vertex: string,
  fragment: string,
  feedback: readonly string[] = [],
): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error("The context is lost.");
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    const log = gl.getShaderInfoLog(shader);
    if (log) throw new Error(log);
  }
  if (feedback.length > 0) {
    gl.transformFeedbackVaryings(program, [...feedback], gl.INTERLEAVED_ATTRIBS);
  }
  gl.linkProgram(program);
  return program;
}

/** State that a control sets once, for it has no other frames to draw. */
export function prepare(
  gl: WebGL2RenderingContext,
  program: WebGLProgram,
  pixels: number,
): WebGLUniformLocation | null {
  gl.useProgram(program);
  gl.uniformMatrix4fv(gl.getUniformLocation(program, "uClipFromWorld"), false, VIEW.clipFromWorld);
  const scale = sizeOf(pixels) * VIEW.projectionScale;
  gl.uniform1f(gl.getUniformLocation(program, "uPointScale"), scale);
  gl.viewport(0, 0, WIDTH, HEIGHT);
  gl.clearColor(0, 0, 0, 1);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE);
  // As in the room, where walls may hide the flame.
  gl.enable(gl.DEPTH_TEST);
  gl.depthMask(true);
  return gl.getUniformLocation(program, "uGlow");
}
