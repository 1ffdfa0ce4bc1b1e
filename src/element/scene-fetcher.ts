import { areSame, loadScene, type Scene, type SceneRequest } from "../scenes/scene.js";

interface Reactions {
  readonly onProgress: (share: number) => void;
  readonly onScene: (scene: Scene) => void;
  readonly onFailure: (error: Error) => void;
  /** What was asked for meanwhile is no longer wanted: what is on show is. */
  readonly onGivenUp: () => void;
}

/**
 * Fetches what is asked for; what was asked for before is no longer wanted. What is on show stays until the
 * new models have come, and if they do not come.
 */
export class SceneFetcher {
  /** What is on show, which while something else is fetched is not what the attributes say. */
  shown: SceneRequest | null = null;
  readonly #asked: () => SceneRequest;
  readonly #signal: AbortSignal;
  readonly #reactions: Reactions;
  #wanted: SceneRequest | null = null;
  #loading: AbortController | null = null;

  /** @param asked what the attributes ask for, at any time */
  constructor(asked: () => SceneRequest, signal: AbortSignal, reactions: Reactions) {
    this.#asked = asked;
    this.#signal = signal;
    this.#reactions = reactions;
  }

  get isFetching(): boolean {
    return this.#wanted !== null;
  }

  /** Something else may be asked for now. */
  follow(): void {
    const asked = this.#asked();
    if (areSame(asked, this.shown)) {
      this.#loading?.abort();
      this.#wanted = null;
      this.shown = asked;
      this.#reactions.onGivenUp();
    } else if (!areSame(asked, this.#wanted)) {
      void this.fetch();
    }
  }

  async fetch(): Promise<void> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    const { signal } = loading;
    this.#signal.addEventListener("abort", () => loading.abort(), { signal });
    const { onProgress, onScene, onFailure } = this.#reactions;
    const wanted = this.#asked();
    this.#wanted = wanted;
    let scene: Scene;
    try {
      scene = await loadScene(wanted, { signal, onProgress });
    } catch (error) {
      if (signal.aborted) return;
      this.#wanted = null;
      onFailure(error as Error);
      return;
    }
    if (signal.aborted) return scene.close();
    this.#wanted = null;
    this.shown = this.#asked();
    onScene(scene);
  }
}
