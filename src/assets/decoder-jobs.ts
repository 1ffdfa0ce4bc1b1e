import { Flaw } from "./asset-error.js";

/** Time limit of one job: a worker that has not answered by then has crashed. Milliseconds. */
const LIMIT = 20_000;

/** Jobs of a decoder's worker, one after the other: the time limit counts decoding alone. */
export class DecoderJobs {
  #fail: (flaw: Flaw) => void = () => {};
  readonly #failure = new Promise<never>((_, reject) => {
    this.#fail = reject;
  });
  #last: Promise<unknown> = Promise.resolve();

  constructor() {
    this.#failure.catch(() => {});
  }

  /** Fails all jobs as soon as the worker does: one that a content security policy blocks sends an error, too. */
  watch(worker: EventTarget): void {
    worker.addEventListener("error", (cause) => this.#fail(cannotRun(cause)), { once: true });
  }

  /** Runs a job when those before it have ended. */
  run<Value>(decode: () => Promise<Value>): Promise<Value> {
    const job = Promise.race([this.#failure, this.#last]).then(() => {
      return Promise.race([this.#failure, withLimit(decode())]);
    });
    this.#last = job.catch(() => {});
    return job;
  }

  /** Fails the jobs that have not ended, and begins none any more. */
  end(): void {
    this.#fail(new Flaw("was given up"));
  }
}

/** Why a decoder does not start. */
export function cannotRun(cause: unknown): Flaw {
  const reason = "its decoder cannot run; a content security policy may forbid it";
  return new Flaw(`is not decoded: ${reason}`, { cause });
}

function withLimit<Value>(work: Promise<Value>): Promise<Value> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const late = new Promise<never>((_, reject) => {
    const flaw = new Flaw("is not decoded: its decoder does not answer");
    timer = setTimeout(() => reject(flaw), LIMIT);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}
