import type { Steps } from "../world/steps.js";

/** Steps that several may continue, and whose result stays. */
export class Task<Result> {
  readonly #steps: Steps<Result>;
  #last: IteratorResult<void, Result> = { value: undefined };

  constructor(steps: Steps<Result>) {
    this.#steps = steps;
  }

  /** Does some of the steps that are left. True when none is. */
  proceed(steps = 1): boolean {
    for (let i = 0; i < steps && !this.#last.done; i++) this.#last = this.#steps.next();
    return this.#last.done === true;
  }

  finish(): Result {
    while (!this.#last.done) this.#last = this.#steps.next();
    return this.#last.value;
  }
}

/** Tasks by what they are for, and by their detail. */
export type Tasks<Owner extends object, Result> = WeakMap<Owner, Map<string, Task<Result>>>;

/** The task of an owner and a detail, begun once. */
export function taskOf<Owner extends object, Result>(
  tasks: Tasks<Owner, Result>,
  owner: Owner,
  detail: unknown,
  begin: () => Steps<Result>,
): Task<Result> {
  const known = tasks.get(owner) ?? new Map<string, Task<Result>>();
  tasks.set(owner, known);
  const key = JSON.stringify(detail);
  const task = known.get(key) ?? new Task(begin());
  known.set(key, task);
  return task;
}
