import { areSame, loadScene, type Scene, type SceneRequest } from "../scenes/scene.js";
import type { Lifecycle } from "./lifecycle.js";

/**
 * Scene fetcher: fetches the scene asked for, and aborts the fetch before it. The shown scene stays until the
 * new models have loaded, and if they fail to load.
 */
export class SceneFetcher {
  /** The scene on show; while another is fetched the attributes ask for that. */
  shownRequest: SceneRequest | null = null;
  readonly #request: () => SceneRequest;
  readonly #signal: AbortSignal;
  readonly #owner: Lifecycle;
  readonly #onScene: (scene: Scene) => void;
  #pending: SceneRequest | null = null;
  #loading: AbortController | null = null;

  /** @param request the request of the attributes, at any time */
  constructor(
    request: () => SceneRequest,
    signal: AbortSignal,
    owner: Lifecycle,
    onScene: (scene: Scene) => void,
  ) {
    this.#request = request;
    this.#signal = signal;
    this.#owner = owner;
    this.#onScene = onScene;
  }

  get isFetching(): boolean {
    return this.#pending !== null;
  }

  /** To be called when an attribute that selects a scene has changed. */
  follow(): void {
    const request = this.#request();
    if (areSame(request, this.shownRequest)) {
      this.#loading?.abort();
      this.#pending = null;
      this.shownRequest = request;
      this.#owner.onFetchDropped();
    } else if (!areSame(request, this.#pending)) {
      void this.fetch();
    }
  }

  async fetch(): Promise<void> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    const { signal } = loading;
    this.#signal.addEventListener("abort", () => loading.abort(), { signal });
    const onProgress = (progress: number) => this.#owner.onProgress(progress);
    const request = this.#request();
    this.#pending = request;
    let scene: Scene;
    try {
      scene = await loadScene(request, { signal, onProgress });
    } catch (error) {
      if (signal.aborted) return;
      this.#pending = null;
      this.#owner.onMissing(error as Error);
      return;
    }
    if (signal.aborted) return scene.close();
    this.#pending = null;
    this.shownRequest = this.#request();
    this.#onScene(scene);
  }
}
