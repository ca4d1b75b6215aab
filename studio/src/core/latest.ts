/** Sends the newest of many values, never more than one at a time: a drag faster than the answers builds no queue. */

export interface Latest<T> {
  send(value: T): void;
  /** When nothing is under way and nothing waits. */
  settled(): Promise<void>;
}

export function latest<T>(carry: (value: T) => Promise<unknown>): Latest<T> {
  let waiting: { value: T } | undefined;
  let run: Promise<void> | undefined;

  async function pump(): Promise<void> {
    while (waiting) {
      const { value } = waiting;
      waiting = undefined;
      try {
        await carry(value);
      } catch {
        // The next value may fare better; who sends says what went wrong.
      }
    }
    run = undefined;
  }

  return {
    send(value) {
      waiting = { value };
      run ??= pump();
    },
    settled: () => run ?? Promise.resolve(),
  };
}
