import type { App } from "../../app.ts";
import type { Checked, Refused } from "../../engine/types.ts";
import { instead } from "../../picture/instead.ts";
import type { Signal } from "../../state/signal.ts";
import { goodText } from "../../state/solving.ts";
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
  const { isShown, show, hide } = instead(app, "check");

  async function drawn(): Promise<Checked> {
    const good = await goodText(app);
    return app.engine.check(good, app.history.now.value.form, { marks: scheme(), pencil_mm: null, pencil_degrees: null, drawn: true });
  }

  /** Whether there is something to draw; it is drawn if it is still `wanted` then. */
  async function draw(wanted: () => boolean): Promise<boolean> {
    const sheet = (await drawn()).overlays[0];
    if (sheet !== undefined && wanted()) show(sheet, true);
    return sheet !== undefined;
  }

  return {
    isShown,
    hide,
    drawn,
    async show() {
      try {
        app.tell(say((await draw(() => app.shown.value === "check")) ? "overlay_shown" : "overlay_none"));
      } catch (why) {
        app.tell((why as Refused).message);
      }
    },
    follow() {
      if (isShown.value) void draw(() => isShown.value).then((isThere) => !isThere && hide(), hide);
    },
  };
}
