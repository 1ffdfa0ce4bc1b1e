import { missCode } from "../assets/asset-error.js";
import { closeModel } from "../assets/model.js";
import { CustomModelRenderer } from "../render/lone-candle/custom-model-renderer.js";
import { clampInside, inset, type Vec3 } from "../world/geometry.js";
import type { Wick } from "../world/standing-candle.js";
import { createPageSmoke, pageSmokePass } from "./page-smoke.js";
import { addressOf } from "./room-models.js";
import type { Loading, Scene, SceneRequest } from "./scene.js";

/** Largest distance of a flame's root from the box of the model, metres. */
const BESIDE = 0.1;

/** A visitor's own candles alone; null where the model has no wick. */
export async function loadCustomCandle(
  request: SceneRequest,
  { signal, onProgress }: Loading,
): Promise<Scene | null> {
  const { loadModel } = await import("../assets/load-model.js").catch(missCode);
  const decoderBase = new URL("decoders/", request.assetRoot).href;
  const options = { signal, onProgress, decoderBase, isCandle: true };
  const model = await loadModel(addressOf(request), options);
  let isMoved = false;
  const box = inset(model.bounds, -BESIDE);
  const wicks = model.wicks.map((wick): Wick => {
    const position: Vec3 = [...wick.position];
    clampInside(position, box);
    if (position.every((x, axis) => x === wick.position[axis])) return wick;
    isMoved = true;
    clampInside(position, model.bounds);
    return { ...wick, position };
  });
  if (isMoved) console.warn("Wicks far from the model were moved to it.");
  const [first, ...others] = wicks;
  if (!first) {
    closeModel(model);
    console.warn("The model has no node named wick: the built-in candle burns in its place.");
    return null;
  }
  return {
    room: null,
    first,
    wicks: others,
    createPlume: createPageSmoke,
    createSample: null,
    moonDirection: null,
    isModelAlone: true,
    prepareRenderer: () => true,
    createRenderer: (screen, tier) =>
      screen.own(new CustomModelRenderer(screen.gpu, model, wicks, tier, pageSmokePass)),
    close: () => closeModel(model),
  };
}
