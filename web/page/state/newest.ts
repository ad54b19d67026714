/** Work that is done one after the other, where only the newest matters. */
export interface Newest<Wanted> {
  /** Does it, as soon as what goes on is done; what waited before is left out. */
  want(wanted: Wanted): void;
  /** Whether something waits, so that what goes on is not the newest. */
  isStale(): boolean;
  isIdle(): boolean;
}

export function newest<Wanted>(work: (wanted: Wanted) => Promise<void>): Newest<Wanted> {
  let next: { wanted: Wanted } | null = null;
  let isWorking = false;

  async function run(): Promise<void> {
    if (isWorking) return;
    isWorking = true;
    try {
      while (next !== null) {
        const { wanted } = next;
        next = null;
        await work(wanted);
      }
    } finally {
      isWorking = false;
    }
  }
  return {
    want(wanted) {
      next = { wanted };
      void run();
    },
    isStale: () => next !== null,
    isIdle: () => !isWorking && next === null,
  };
}
