import particleFrag from "../../shaders/paper/particle.frag";
import particleVert from "../../shaders/paper/particle.vert";
import { Gpu } from "../../src/gl/gpu.js";
import { ParticleSystem, particleProgram } from "../../src/render/particle-system.js";
import { GROUPS, type ParticleLayer } from "../../src/world/particle-layer.js";
import { layerKey } from "../../src/world/particles.js";
import { MEMORY, TICK, Timeline } from "../../src/world/timeline.js";
import { type Cell, FRAME, HEIGHT, LAW, sizeOf, VIEW, WIDTH } from "./law.js";
import type { Peer } from "./peer.js";

const STILL = [0, 0, 0];

function layerOf({ count, pixels }: Cell): ParticleLayer {
  const capacity = GROUPS * Math.ceil((count + 1) / GROUPS);
  const rate = count / LAW.life;
  return { ...LAW, name: "core", capacity, rate, drag: 0.12, follow: 1, size: sizeOf(pixels) };
}

/** Particles as the element has them, with nothing else in the picture. */
export function ours(canvas: HTMLCanvasElement, cell: Cell): Peer {
  const gpu = new Gpu(canvas);
  const layer = layerOf(cell);
  const system = new ParticleSystem(gpu, particleProgram(gpu), layer, layerKey(1, 0));
  const program = gpu.program("paper/particle", particleVert, particleFrag);
  const block = gpu.uniformBlock(program, "Frame");
  const timeline = new Timeline(-MEMORY);
  const pass = (ticks: number) => {
    for (let i = 0; i < ticks; i++) timeline.record(STILL, STILL, GROUPS);
    system.follow(timeline);
  };
  pass(MEMORY);
  const gl = canvas.getContext("webgl2");
  if (!gl) throw new Error("The context is lost.");
  return {
    name: "candle-flame",
    gl,
    glow: [1, 1, 1],
    frame() {
      pass(FRAME / TICK);
      block.update({
        clipFromWorld: VIEW.clipFromWorld,
        eyePosition: VIEW.eye,
        exposure: 1,
        viewport: [WIDTH, HEIGHT],
        projectionScale: VIEW.projectionScale,
        normalMaps: 1,
      });
      gpu.clear("canvas", [0, 0, 0, 1]);
      gpu.draw({
        program,
        target: "canvas",
        vertexArray: system.vertexArray,
        primitive: "points",
        count: system.count,
        uniforms: {
          uWorldFromFlame: [0, 0, 0, 1],
          uAhead: 0,
          uSize: layer.size,
          uFading: 1,
          uGradient: 1,
          uHaze: 0,
          uGlow: this.glow[0],
        },
        blocks: { Frame: block },
        blend: "premultiplied",
        depth: "test",
        cull: "none",
      });
    },
    dispose: () => gpu.dispose(),
  };
}
