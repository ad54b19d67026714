import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { button } from "../dom/worded.ts";
import { say } from "../layout/words.ts";
import { signal, type Signal } from "../state/signal.ts";

/** A sheet in place of the picture, until somebody wants the picture back. */
export interface Instead {
  isShown: Signal<boolean>;
  /** A sheet is there to be read; what is `drawn`, to be seen whole. */
  show(sheet: { svg: string; width: number; height: number }, drawn?: boolean): void;
  hide(): void;
}

/** The one that is shown: a sheet takes the place of another. */
let present: Signal<boolean> | null = null;

/** For a panel: its sheet goes with it. */
export function instead(app: App, panel: string): Instead {
  const isShown = signal(false);
  const back = button(() => say("back_to_picture"), hide, { class: "floating back", hidden: true });
  byId("pane").append(back);
  // On a telephone the sheet has the whole screen.
  isShown.on((is) => {
    const had = document.activeElement;
    document.body.classList.toggle("reading", is);
    back.hidden = !is;
    if (is && had instanceof HTMLElement && had.offsetParent === null) back.focus();
  });
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
    show(sheet, drawn = false) {
      if (present !== isShown) present?.set(false);
      present = isShown;
      document.body.classList.toggle("whole", drawn);
      app.picture.set({ ...sheet, panels: [], handles: [], drives: app.picture.value?.drives ?? [], notes: [] });
      isShown.set(true);
    },
  };
}
