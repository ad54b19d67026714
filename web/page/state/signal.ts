/** A value that tells when it changes. */
export interface Signal<T> {
  readonly value: T;
  set(value: T): void;
  /** Calls `listener` now and after every change; the answer ends that. What is built by `owned` ends with its owner. */
  on(listener: (value: T) => void): () => void;
}

/** Where subscriptions are noted that are made just now; null where they last as long as the page. */
let owner: (() => void)[] | null = null;

/**
 * Builds a part of the page that will be built anew, or go: what it listens to ends when `end` is called, for a signal that is still
 * listened to keeps all that its listener knows. Only what is subscribed before `build` returns is noted.
 */
export function owned<Made>(build: () => Made): { made: Made; end(): void } {
  const outer = owner;
  const own: (() => void)[] = [];
  owner = own;
  try {
    const made = build();
    const end = (): void => own.splice(0).forEach((each) => each());
    outer?.push(end);
    return { made, end };
  } finally {
    owner = outer;
  }
}

export function signal<T>(first: T): Signal<T> {
  const listeners = new Set<(value: T) => void>();
  let value = first;
  return {
    get value() {
      return value;
    },
    set(next) {
      if (Object.is(next, value)) return;
      value = next;
      for (const listener of [...listeners]) listener(value);
    },
    on(listener) {
      const end = (): void => void listeners.delete(listener);
      listeners.add(listener);
      owner?.push(end);
      listener(value);
      return end;
    },
  };
}
