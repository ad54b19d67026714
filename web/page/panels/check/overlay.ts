import type { App } from "../../app.ts";
import type { Checked, Refused } from "../../engine/types.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { say } from "./words.ts";

/** The student's drawing over the right one, in place of the picture. */
export interface Overlay {
  isShown: Signal<boolean>;
  show(): Promise<void>;
  hide(): void;
  /** Draws it anew for another form; hides it where nothing is off any more. */
  follow(): void;
  /** The check with what is drawn. */
  drawn(): Promise<Checked>;
}

export function overlay(app: App, scheme: () => string | null): Overlay {
  const isShown = signal(false);

  function drawn(): Promise<Checked> {
    const { good } = app.solved.value;
    return app.engine.check(good, app.history.now.value.form, { marks: scheme(), pencil_mm: null, pencil_degrees: null, drawn: true });
  }

  async function draw(): Promise<boolean> {
    const { overlays } = await drawn();
    const sheet = overlays[0];
    if (sheet === undefined) return false;
    app.picture.set({ ...sheet, panels: [], handles: [], drives: app.picture.value?.drives ?? [], notes: [] });
    return true;
  }

  function hide(): void {
    if (!isShown.value) return;
    isShown.set(false);
    app.view.set({ ...app.view.value });
  }

  async function show(): Promise<void> {
    try {
      const isThere = await draw();
      isShown.set(isThere);
      app.tell(say(isThere ? "overlay_shown" : "overlay_none"));
    } catch (why) {
      app.tell((why as Refused).message);
    }
  }

  // Whoever draws, steps or plays wants the picture back.
  app.picture.on((picture) => picture !== null && picture.panels.length > 0 && isShown.set(false));
  app.shown.on((panel) => panel !== "check" && hide());
  return { isShown, show, hide, drawn, follow: () => void (isShown.value && draw().then((isThere) => !isThere && hide(), hide)) };
}
