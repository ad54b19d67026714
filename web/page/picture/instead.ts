import type { App } from "../app.ts";
import { signal, type Signal } from "../state/signal.ts";

/** A sheet in place of the picture, until somebody wants the picture back. */
export interface Instead {
  isShown: Signal<boolean>;
  show(sheet: { svg: string; width: number; height: number }): void;
  hide(): void;
}

/** For a panel: its sheet goes with it. */
export function instead(app: App, panel: string): Instead {
  const isShown = signal(false);
  function hide(): void {
    if (!isShown.value) return;
    isShown.set(false);
    app.view.set({ ...app.view.value });
  }
  // Whoever draws, steps or plays wants the picture back; a sheet has no panels to be looked at one by one.
  app.picture.on((picture) => picture !== null && picture.panels.length > 0 && isShown.set(false));
  app.shown.on((shown) => shown !== panel && hide());
  return {
    isShown,
    hide,
    show(sheet) {
      app.picture.set({ ...sheet, panels: [], handles: [], drives: app.picture.value?.drives ?? [], notes: [] });
      isShown.set(true);
    },
  };
}
