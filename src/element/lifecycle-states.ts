/** State of the element between its insertion into a document and its removal. */
export type LifecycleState = keyof typeof TRANSITIONS;

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
const TRANSITIONS = {
  /** Not in a document: nothing is held. */
  detached: { connect: "deferred" },
  /** Waits for the viewport to come near, with `loading="lazy"`. */
  deferred: { ...RESTART, approach: "queued" },
  /** Waits for one of the page's WebGL contexts. */
  queued: { ...RESTART, admit: "loading" },
  /** Fetches models and compiles programs. */
  loading: { ...FAIL, reveal: "running", lose: "loading-lost" },
  /** Draws, or could. */
  running: { ...FAIL, lose: "running-lost" },
  /** The WebGL context is lost, before or after the first frame. */
  "loading-lost": { ...FAIL, restore: "loading" },
  "running-lost": { ...FAIL, restore: "running" },
  /** A sentence says why there is no frame. */
  failed: RESTART,
} as const satisfies Record<string, Readonly<Partial<Record<LifecycleEvent, string>>>>;

/** State machine of the element's lifecycle. It does nothing by itself: see `Lifecycle`. */
export class LifecycleStates {
  #current: LifecycleState = "detached";

  get current(): LifecycleState {
    return this.#current;
  }

  /** Takes the transition of an event. Returns whether there is one from the current state. */
  send(event: LifecycleEvent): boolean {
    const from: Readonly<Partial<Record<LifecycleEvent, LifecycleState>>> =
      TRANSITIONS[this.#current];
    const next = from[event];
    this.#current = next ?? this.#current;
    return next !== undefined;
  }
}
