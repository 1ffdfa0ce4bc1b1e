import { readBuiltInModel } from "../assets/built-in-model.js";
import { closeModel, type Model } from "../assets/model.js";
import { LoneCandleRenderer } from "../render/lone-candle-renderer.js";
import { createPageSmoke, pageSmokePass } from "./page-smoke.js";
import type { Loading, Scene, SceneRequest } from "./scene.js";

/** The candle alone, whatever the look. */
export async function loadLoneCandle(
  { assetRoot }: SceneRequest,
  { signal, onProgress }: Loading,
): Promise<Scene> {
  const url = new URL("models/chamberstick.glb", assetRoot);
  const model: Model = await readBuiltInModel(url, signal, onProgress);
  return {
    room: null,
    first: null,
    wicks: [],
    createPlume: createPageSmoke,
    createSample: null,
    moonDirection: null,
    isModelAlone: true,
    prepareRenderer: () => true,
    createRenderer: (screen, tier) =>
      screen.own(new LoneCandleRenderer(screen.gpu, model, tier, pageSmokePass)),
    close: () => closeModel(model),
  };
}
