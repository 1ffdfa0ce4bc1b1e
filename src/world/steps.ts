/** Work in steps, of which each frame does a few. */
export type Steps<Result = void> = Generator<void, Result>;

/** All of the steps at once. */
export function finish<Result>(steps: Steps<Result>): Result {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
