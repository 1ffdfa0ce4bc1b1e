import { describe, expect, test } from "vitest";
import {
  type LifecycleEvent,
  type LifecycleState,
  LifecycleStates,
} from "../../../src/element/lifecycle-states.ts";

/** The state after a sequence of events, each of which has to have a transition. */
function after(...events: LifecycleEvent[]): LifecycleState {
  const machine = new LifecycleStates();
  for (const event of events)
    expect(machine.send(event), `${event} in ${machine.current}`).toBe(true);
  return machine.current;
}

const LOADING = ["connect", "approach", "admit"] as const;
const RUNNING = [...LOADING, "reveal"] as const;
/** A way into each state. */
const WAYS: Readonly<Record<LifecycleState, readonly LifecycleEvent[]>> = {
  detached: [],
  deferred: ["connect"],
  queued: ["connect", "approach"],
  loading: LOADING,
  running: RUNNING,
  "loading-lost": [...LOADING, "lose"],
  "running-lost": [...RUNNING, "lose"],
  failed: [...LOADING, "fail"],
};
const STATES = Object.keys(WAYS) as LifecycleState[];

test.each(STATES)("the state %s can be reached", (state) => {
  expect(after(...WAYS[state])).toBe(state);
});

describe("a lost context", () => {
  test("comes back to where it was lost", () => {
    expect(after(...LOADING, "lose", "restore")).toBe("loading");
    expect(after(...RUNNING, "lose", "restore")).toBe("running");
  });

  test("is reported once until it is restored", () => {
    const machine = new LifecycleStates();
    for (const event of RUNNING) machine.send(event);
    expect(machine.send("lose")).toBe(true);
    expect(machine.send("lose")).toBe(false);
    expect(machine.send("restore")).toBe(true);
    expect(machine.send("lose")).toBe(true);
  });

  test("lets nothing be revealed", () => {
    const machine = new LifecycleStates();
    for (const event of [...LOADING, "lose", "reveal"] as const) machine.send(event);
    expect(machine.current).toBe("loading-lost");
  });
});

describe("a failure", () => {
  test.each(["loading", "running", "loading-lost", "running-lost"] as const)(
    "ends the state %s, and a restart begins anew",
    (state) => {
      expect(after(...WAYS[state], "fail")).toBe("failed");
      expect(after(...WAYS[state], "fail", "restart")).toBe("deferred");
    },
  );

  test.each(["detached", "deferred", "queued", "failed"] as const)(
    "of what is over changes nothing in the state %s",
    (state) => {
      const machine = new LifecycleStates();
      for (const event of WAYS[state]) machine.send(event);
      expect(machine.send("fail")).toBe(false);
      expect(machine.current).toBe(state);
    },
  );
});

test.each(STATES.filter((state) => state !== "detached"))(
  "an element taken out in the state %s is detached, and can be put back",
  (state) => {
    expect(after(...WAYS[state], "disconnect")).toBe("detached");
    expect(after(...WAYS[state], "disconnect", "connect")).toBe("deferred");
  },
);

test("an element moved within the page in one task does not begin again", () => {
  const machine = new LifecycleStates();
  for (const event of RUNNING) machine.send(event);
  expect(machine.send("connect")).toBe(false);
  expect(machine.current).toBe("running");
});
