import type { TierName } from "./passes.js";
import { median } from "./statistics.js";

const SIZE = { width: 160, height: 90 } as const;
const PLACE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
const CAMERA = { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 } as const;
/** Seconds of a frame, and metres and radians of its way. */
const FRAME = 1 / 60;
const STRIDE = { away: 0.023, turned: 0.01 } as const;
/** Frames that are measured, to and fro, and those before, in which V8 compiles. */
const FRAMES = 600;
const CYCLE = 40;
const WARM = 240;
/** Calls that make work for a driver. */
const DRAWING = ["clear", "drawArrays", "drawElements", "blitFramebuffer"] as const;

/** Main thread's time of a frame, milliseconds: medians. */
export interface ScriptCost {
  readonly atRest: number;
  readonly inMotion: number;
}

/** Our script alone, as on a GPU: the driver has nothing to draw, so that no call waits for it. */
export async function measureScript(quality: TierName): Promise<ScriptCost> {
  const { prototype } = WebGL2RenderingContext;
  const { getParameter } = prototype;
  prototype.getParameter = function (name) {
    return name === this.RENDERER ? "A GPU" : getParameter.call(this, name);
  };
  const element = document.createElement("candle-flame");
  Object.assign(element, { paused: true, look: "physical", quality, assetBase: "/" });
  element.style.cssText = `width: ${SIZE.width}px; height: ${SIZE.height}px`;
  document.body.replaceChildren(element);
  await element.ready;
  element.camera = CAMERA;
  element.step(1);
  for (const call of DRAWING) prototype[call] = () => {};
  const timesOf = (isMoving: boolean) => {
    const times: number[] = [];
    element.play();
    for (let frame = -WARM; frame < FRAMES; frame++) {
      const way = Math.abs((((frame % CYCLE) + CYCLE) % CYCLE) - CYCLE / 2);
      const [x, y, z] = CAMERA.position;
      const position = [x - STRIDE.away * way, y, z] as const;
      if (isMoving) {
        element.camera = { ...CAMERA, position, yaw: CAMERA.yaw + STRIDE.turned * way };
      }
      const begin = performance.now();
      element.step(FRAME);
      if (frame >= 0) times.push(performance.now() - begin);
    }
    element.pause();
    return median(times);
  };
  const inMotion = timesOf(true);
  element.camera = PLACE;
  element.place();
  element.camera = CAMERA;
  const atRest = timesOf(false);
  element.remove();
  return { atRest, inMotion };
}
