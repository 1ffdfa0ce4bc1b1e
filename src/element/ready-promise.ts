/** The element's promise `ready`, which is replaced when another first frame is to come. */
export class ReadyPromise {
  #isSettled = false;
  #resolve: () => void = () => {};
  #reject: (error: Error) => void = () => {};
  #promise: Promise<void> = this.#create();

  get promise(): Promise<void> {
    return this.#promise;
  }

  resolve(): void {
    this.#isSettled = true;
    this.#resolve();
  }

  reject(error: Error): void {
    this.#isSettled = true;
    this.#reject(error);
  }

  /** A promise of another first frame, unless the last one is still pending. */
  renew(): void {
    if (this.#isSettled) this.#promise = this.#create();
  }

  #create(): Promise<void> {
    this.#isSettled = false;
    const promise = new Promise<void>((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    promise.catch(() => {}); // the event `error` says the same
    return promise;
  }
}
