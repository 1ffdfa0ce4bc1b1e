/** The element's promise `ready`, which is replaced when another first frame is to come. */
export class ReadyPromise {
  /** Resolves the promise, or rejects it with an error. */
  settle: (error?: Error) => void = () => {};
  #isSettled = false;
  promise = this.#create();

  /** A promise of another first frame, unless the last one is still pending. */
  renew(): void {
    if (this.#isSettled) this.promise = this.#create();
  }

  #create(): Promise<void> {
    this.#isSettled = false;
    const promise = new Promise<void>((resolve, reject) => {
      this.settle = (error) => {
        this.#isSettled = true;
        if (error) reject(error);
        else resolve();
      };
    });
    promise.catch(() => {}); // the event `error` says the same
    return promise;
  }
}
