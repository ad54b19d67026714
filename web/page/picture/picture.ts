import type { Shown } from "../app.ts";
import type { View } from "../engine/types.ts";
import { orTell } from "../refused.ts";
import { newest } from "../state/newest.ts";
import type { Signal } from "../state/signal.ts";

/** How long a layout takes to become another, in ms. */
const EASING = 200;

/** Keeps the picture that of the document on its surface. */
export interface Current {
  /** Draws it again. */
  again(): void;
  /** Lets the next picture ease over from the layout of the gesture that is over, unless somebody wants little motion. */
  ease(): void;
}

/** The newest wins, one is under way at a time. `held` says that a gesture shows its own. */
export function currentPicture(app: Shown, sight: Signal<View>, held: () => boolean): Current {
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  let eases = false;

  async function show(text: string, view: View): Promise<void> {
    const picture = await app.engine.picture(text, view);
    if (!held()) app.picture.set(picture);
  }

  const drawing = newest(({ text, view }: { text: string; view: View }) =>
    orTell(app, async () => {
      const begin = performance.now();
      for (let way = 0; eases && way < 1 && !held() && !drawing.isStale(); way = (performance.now() - begin) / EASING) {
        await show(text, { ...view, eased: way * way * (3 - 2 * way) });
        await new Promise(requestAnimationFrame);
      }
      eases &&= drawing.isStale();
      await show(text, view);
    }),
  );

  function again(): void {
    const { good } = app.solved.value;
    if (good !== "") drawing.want({ text: good, view: sight.value });
  }

  let shown = "";
  app.solved.on(({ good }) => {
    if (good === shown) return;
    shown = good;
    again();
  });
  sight.on(again);
  return { again, ease: () => (eases = !calm.matches) };
}
