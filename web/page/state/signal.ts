/** A value that tells when it changes. */
export interface Signal<T> {
  readonly value: T;
  set(value: T): void;
  /** Calls `listener` now and after every change; the answer ends that. */
  on(listener: (value: T) => void): () => void;
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
      listeners.add(listener);
      listener(value);
      return () => listeners.delete(listener);
    },
  };
}
