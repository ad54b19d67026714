import type { App } from "../../app.ts";
import type { Signal } from "../../state/signal.ts";

/** What is watched: anything that tells when it changes. */
type Watched = Pick<Signal<unknown>, "on">;

/**
 * Keeps a panel current while it is shown: `refresh` runs when something watched has changed since it last ran, one run after the
 * other, and the newest change wins. What changes while the panel is hidden waits until it is shown.
 */
export function keepCurrent(app: App, panel: string, watched: Watched[], refresh: () => Promise<void>): void {
  let isStale = true;
  let isRunning = false;
  async function run(): Promise<void> {
    if (isRunning) return;
    isRunning = true;
    try {
      while (isStale && app.shown.value === panel) {
        isStale = false;
        await refresh();
      }
    } finally {
      isRunning = false;
    }
  }
  for (const signal of watched) {
    signal.on(() => {
      isStale = true;
      void run();
    });
  }
  app.shown.on(() => void run());
}
