import { AssetError, missCode } from "../assets/asset-error.js";
import { closeModel, type Model } from "../assets/model.js";
import type { Models } from "../render/renderer.js";
import type { Look } from "../settings.js";
import { withMeanColors } from "./mean-colors.js";
import { resolveUrl } from "./resolve-url.js";
import type { Loading, SceneRequest } from "./scene.js";

/** Models that the built-in rooms are made of, under `asset-base`. */
const BUILT_IN: Readonly<Record<Look, Readonly<Record<keyof Models, string>>>> = {
  physical: { room: "models/cabin.glb", candle: "models/chamberstick.glb" },
  paper: { room: "models/paper-room.glb", candle: "models/paper-candle.glb" },
  original: { room: "models/paper-room.glb", candle: "models/paper-candle.glb" },
};

/** Longest address that a sentence repeats. */
const REPEATED = 80;

/** The absolute address of a visitor's model. */
export function addressOf({ src, baseURI }: SceneRequest): string {
  const address = resolveUrl(src, baseURI);
  if (address !== null) return address;
  throw new AssetError(`The model's address is none that can be read: ${src.slice(0, REPEATED)}`);
}

/** Fetches and decodes a look's models. three.js comes with the first of them. */
export async function loadModels(
  request: SceneRequest,
  { signal, onProgress }: Loading,
): Promise<Models> {
  const { look, src, assetRoot } = request;
  const builtIn = (name: keyof Models) => new URL(BUILT_IN[look][name], assetRoot).href;
  const sources = {
    room: src === "" ? builtIn("room") : addressOf(request),
    candle: builtIn("candle"),
  };
  const { loadModel } = await import("../assets/load-model.js").catch(missCode);
  const progress = { room: 0, candle: 0 };
  const sharedImages = new Map();
  const load = (name: keyof Models): Promise<Model> =>
    loadModel(sources[name], {
      signal,
      sharedImages,
      decoderBase: new URL("decoders/", assetRoot).href,
      onProgress: (fraction) => {
        progress[name] = Math.max(progress[name], fraction);
        // The room is most of the download.
        if (!signal.aborted) onProgress((progress.room * 3 + progress.candle) / 4);
      },
    });
  const results = await Promise.allSettled([load("room"), load("candle")]);
  const models = results.flatMap((one) => (one.status === "fulfilled" ? one.value : []));
  const [room, candle] = models;
  if (room && candle && !signal.aborted) {
    return { room: src === "" ? room : withMeanColors(room), candle };
  }
  models.forEach(closeModel);
  signal.throwIfAborted();
  throw results.find((one) => one.status === "rejected")?.reason;
}
