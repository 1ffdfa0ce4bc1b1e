import particleFrag from "../../shaders/paper/particle.frag";
import particleVert from "../../shaders/paper/particle.vert";
import { Gpu } from "../../src/gl/gpu.js";
import { FEEDBACK, ParticleSystem } from "../../src/render/volumetric/particle-system.js";
import { GROUPS, type ParticleLayer } from "../../src/world/particles/particle-layer.js";
import { layerKey } from "../../src/world/particles/particles.js";
import { HISTORY, TICK, Timeline } from "../../src/world/timeline.js";
import { type Cell, FRAME, LAW, sizeOf, VIEW } from "./law.js";
import type { Peer } from "./peer.js";

const STILL = [0, 0, 0];

function layerOf({ count, pixels }: Cell): ParticleLayer {
  const capacity = GROUPS * Math.ceil((count + 1) / GROUPS);
  const rate = count / LAW.life;
  const ours = { name: "core", source: "flame", spawnDepth: 0, drag: 0.12, follow: 1 } as const;
  return { ...LAW, ...ours, capacity, rate, size: sizeOf(pixels) };
}

/** Particles as the element has them, with nothing else in the picture. */
export function ours(canvas: HTMLCanvasElement, cell: Cell): Peer {
  const gpu = new Gpu(canvas);
  const layer = layerOf(cell);
  const system = new ParticleSystem(gpu, layer, layerKey(1, 0));
  const program = gpu.program("paper/particle", particleVert, particleFrag, {
    defines: { HAZE: 0, GRADIENT: 1 },
    feedback: FEEDBACK,
  });
  const timeline = new Timeline(-HISTORY);
  const record = (ticks: number) => {
    for (let i = 0; i < ticks; i++) timeline.record(STILL, STILL, GROUPS);
  };
  record(HISTORY);
  const clipFromFlame = new Float32Array(VIEW.clipFromWorld);
  const gl = canvas.getContext("webgl2");
  if (!gl) throw new Error("The context is lost.");
  return {
    name: "candle-flame",
    gl,
    glow: [1, 1, 1],
    frame() {
      record(FRAME / TICK);
      gpu.clear("canvas", [0, 0, 0, 1]);
      system.draw(timeline, {
        program,
        target: "canvas",
        uniforms: {
          uClipFromFlame: clipFromFlame,
          uSize: layer.size * VIEW.projectionScale,
          uExtrapolation: 0,
          uFading: 1,
          uGlow: this.glow[0],
        },
        blend: "premultiplied",
        depth: "test",
        cull: "none",
      });
    },
    dispose: () => gpu.dispose(),
  };
}
