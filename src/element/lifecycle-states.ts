/** State of the element between its insertion into a document and its removal. */
export type LifecycleState =
  /** Not in a document: nothing is held. */
  | "detached"
  /** Waits for the viewport to come near, with `loading="lazy"`. */
  | "deferred"
  /** Waits for one of the page's WebGL contexts. */
  | "queued"
  /** Fetches models and compiles programs. */
  | "loading"
  /** Draws, or could. */
  | "running"
  /** The WebGL context is lost, before or after the first frame. */
  | "loading-lost"
  | "running-lost"
  /** A sentence says why there is no frame. */
  | "failed";

export type LifecycleEvent =
  | "connect"
  | "disconnect"
  /** The viewport is near, or is not waited for. */
  | "approach"
  /** A WebGL context may be created. */
  | "admit"
  /** The first frame is drawn. */
  | "reveal"
  | "lose"
  | "restore"
  | "fail"
  /** Restarts: for another scene, after a failure, or when the context went to another element. */
  | "restart";

const RESTART = { restart: "deferred", disconnect: "detached" } as const;
const FAIL = { ...RESTART, fail: "failed" } as const;

/** Transitions: the state that an event leads to. Events that are not listed have no effect. */
const TRANSITIONS: Readonly<
  Record<LifecycleState, Readonly<Partial<Record<LifecycleEvent, LifecycleState>>>>
> = {
  detached: { connect: "deferred" },
  deferred: { ...RESTART, approach: "queued" },
  queued: { ...RESTART, admit: "loading" },
  loading: { ...FAIL, reveal: "running", lose: "loading-lost" },
  running: { ...FAIL, lose: "running-lost" },
  "loading-lost": { ...FAIL, restore: "loading" },
  "running-lost": { ...FAIL, restore: "running" },
  failed: RESTART,
};

/** State machine of the element's lifecycle. It does nothing by itself: see `Lifecycle`. */
export class LifecycleStates {
  #current: LifecycleState = "detached";

  get current(): LifecycleState {
    return this.#current;
  }

  /** Takes the transition of an event. Returns whether there is one from the current state. */
  send(event: LifecycleEvent): boolean {
    const next = TRANSITIONS[this.#current][event];
    this.#current = next ?? this.#current;
    return next !== undefined;
  }
}
