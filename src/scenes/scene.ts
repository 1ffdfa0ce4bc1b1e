import { AssetError, missCode } from "../assets/asset-error.js";
import type { Tier } from "../render/quality.js";
import type { Renderer } from "../render/renderer.js";
import type { Look, SceneName } from "../settings.js";
import type { CreatePlume } from "../world/air/plume.js";
import type { Vec3 } from "../world/geometry.js";
import type { MoonWish } from "../world/moon.js";
import type { CreateSample } from "../world/particles/particles.js";
import type { Room } from "../world/room/room.js";
import type { Wick } from "../world/standing-candle.js";
import type { CanvasTarget } from "./canvas-target.js";
import type { NextParts, NextRenderer } from "./next-renderer.js";
import { fetchPageSmoke } from "./page-smoke.js";
import type { Refinement, RefinementParts } from "./refinement.js";

/** Scene: the models of a room or of a lone candle, fetched and decoded. */
export interface Scene {
  /** The room to walk in; null where there is none, or where the look has a box. */
  readonly room: Room | null;
  /** Wick of the first candle, where that is not a built-in model's. */
  readonly first: Wick | null;
  /** Wicks of the models, beside the first candle's. */
  readonly wicks: readonly Wick[];
  /** Makes hot air and smoke; null where they are not drawn. */
  readonly createPlume: CreatePlume | null;
  /** Makes the particles that the light of the paper's looks follows; null where those are not drawn. */
  readonly createSample: CreateSample | null;
  /** Direction in which the room's own moonlight goes, of length 1; null where it has none. */
  readonly moonDirection: Vec3 | null;
  /** Whether there is nothing but a model on the page's own background. */
  readonly isModelAlone: boolean;
  /** Goes on, for a few milliseconds, with what a renderer needs. True when it can be made at once. */
  prepareRenderer(
    screen: CanvasTarget,
    tier: Tier,
    settings: { readonly look: Look; readonly moon: MoonWish },
  ): boolean;
  createRenderer(screen: CanvasTarget, tier: Tier, look: Look): Renderer;
  /** Where an image at rest is refined without a GPU. */
  readonly createRefinement?: (parts: () => RefinementParts) => Refinement;
  /** Where another tier's renderer is prepared while the one before draws. */
  readonly createNext?: (parts: () => NextParts) => NextRenderer;
  /** Frees what was fetched. */
  close(): void;
}

/** Request of a scene: everything that decides which files are fetched. */
export interface SceneRequest {
  readonly scene: SceneName;
  readonly look: Look;
  /** URL of the visitor's own room or candle, or empty for the built-in one. */
  readonly src: string;
  /** URL that `src` is relative to. */
  readonly baseURI: string;
  /** URL of the folder that built-in models lie in; empty where it is not known. */
  readonly assetRoot: string;
  /** Whether only steps advance time: their images must not depend on when code arrives. */
  readonly isStepped: boolean;
}

/** Whether two requests ask for the same files. */
export function areSame(one: SceneRequest, other: SceneRequest | null | undefined): boolean {
  const key = ({ scene, look, src, assetRoot }: SceneRequest) =>
    JSON.stringify([scene === "candle" ? scene : look === "physical", src, assetRoot]);
  return !!other && key(one) === key(other);
}

export interface Loading {
  readonly signal: AbortSignal;
  /** Called with the share done, 0 to 1, never falling. */
  readonly onProgress: (progress: number) => void;
}

const NO_ASSETS =
  "This code does not know where its models and textures are. Set the attribute asset-base to their folder.";

/** Fetches a scene, and first the code that it needs: each scene is a chunk of its own. */
export async function loadScene(request: SceneRequest, loading: Loading): Promise<Scene> {
  if (request.assetRoot === "") throw new AssetError(NO_ASSETS);
  if (request.scene === "candle") {
    if (request.isStepped) await fetchPageSmoke();
    if (request.src !== "") {
      const { loadCustomCandle } = await import("./custom-candle-scene.js").catch(missCode);
      const own = await loadCustomCandle(request, loading);
      if (own) return own;
    }
    const { loadLoneCandle } = await import("./candle-scene.js").catch(missCode);
    return loadLoneCandle(request, loading);
  }
  const { loadRoom } = await import("./room-scene.js").catch(missCode);
  return loadRoom(request, loading);
}
