/** The element's promise `ready`, which is replaced when another first frame is to come. */
export class ReadyPromise {
  /** Resolves the promise, or rejects it with an error. */
  settle: (error?: Error) => void = () => {};
  #isSettled = false;
  #isRejected = false;
  promise = this.#create();

  /** A promise of another first frame, unless the last one is still pending. */
  renew(): void {
    if (this.#isSettled) this.promise = this.#create();
  }

  /** The same if it was rejected. Returns whether it was. */
  renewRejected(): boolean {
    const wasRejected = this.#isRejected;
    if (wasRejected) this.renew();
    return wasRejected;
  }

  #create(): Promise<void> {
    this.#isSettled = false;
    this.#isRejected = false;
    const promise = new Promise<void>((resolve, reject) => {
      this.settle = (error) => {
        if (!this.#isSettled) this.#isRejected = error !== undefined;
        this.#isSettled = true;
        if (error) reject(error);
        else resolve();
      };
    });
    promise.catch(() => {}); // the event `error` says the same
    return promise;
  }
}
