import type { App } from "../app.ts";
import type { View } from "../engine/types.ts";
import { orTell } from "../refused.ts";
import { newest } from "../state/newest.ts";

/** Keeps the picture that of the document and the view; the newest wins, one is under way at a time. `held` says that a gesture shows its own. */
export function currentPicture(app: App, held: () => boolean): { again(): void } {
  const drawing = newest(({ text, view }: { text: string; view: View }) =>
    orTell(app, async () => {
      const picture = await app.engine.picture(text, view);
      if (!held()) app.picture.set(picture);
    }),
  );

  function again(): void {
    const { good } = app.solved.value;
    if (good !== "") drawing.want({ text: good, view: app.view.value });
  }

  let shown = "";
  app.solved.on(({ good }) => {
    if (good === shown) return;
    shown = good;
    again();
  });
  app.view.on(again);
  return { again };
}
