import { areSame, loadScene, type Scene, type SceneRequest } from "../scenes/scene.js";

export interface FetchObserver {
  onProgress(progress: number): void;
  /** The scene asked for cannot be fetched. */
  onMissing(error: Error): void;
  /** The fetch was aborted: the attributes ask for the scene that is shown. */
  onFetchDropped(): void;
}

/**
 * Scene fetcher: fetches the scene asked for, and aborts the fetch before it. The shown scene stays until the
 * new models have loaded, and if they fail to load.
 */
export class SceneFetcher {
  /** Request of the scene that is shown. */
  shown: SceneRequest | null = null;
  readonly #asked: () => SceneRequest;
  readonly #signal: AbortSignal;
  readonly #observer: FetchObserver;
  readonly #onScene: (scene: Scene) => void;
  #wanted: SceneRequest | null = null;
  #loading: AbortController | null = null;

  /** @param asked the request of the attributes, at any time */
  constructor(
    asked: () => SceneRequest,
    signal: AbortSignal,
    observer: FetchObserver,
    onScene: (scene: Scene) => void,
  ) {
    this.#asked = asked;
    this.#signal = signal;
    this.#observer = observer;
    this.#onScene = onScene;
  }

  get isFetching(): boolean {
    return this.#wanted !== null;
  }

  /** To be called when an attribute that selects a scene has changed. */
  follow(): void {
    const asked = this.#asked();
    if (areSame(asked, this.shown)) {
      this.#loading?.abort();
      this.#wanted = null;
      this.shown = asked;
      this.#observer.onFetchDropped();
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
    const onProgress = (progress: number) => this.#observer.onProgress(progress);
    const wanted = this.#asked();
    this.#wanted = wanted;
    let scene: Scene;
    try {
      scene = await loadScene(wanted, { signal, onProgress });
    } catch (error) {
      if (signal.aborted) return;
      this.#wanted = null;
      this.#observer.onMissing(error as Error);
      return;
    }
    if (signal.aborted) return scene.close();
    this.#wanted = null;
    this.shown = this.#asked();
    this.#onScene(scene);
  }
}
