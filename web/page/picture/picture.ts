import type { App } from "../app.ts";
import type { Picture, Refused, View } from "../engine/types.ts";

/** Keeps the picture that of the document and the view; the newest wins, one is under way at a time. `held` says that a gesture shows its own. */
export function currentPicture(app: App, held: () => boolean): { again(): void } {
  let wanted: { text: string; view: View } | null = null;
  let isDrawing = false;

  async function draw(): Promise<void> {
    if (isDrawing) return;
    isDrawing = true;
    while (wanted !== null) {
      const { text, view } = wanted;
      wanted = null;
      try {
        const picture: Picture = await app.engine.picture(text, view);
        if (!held()) app.picture.set(picture);
      } catch (why) {
        app.tell((why as Refused).message);
      }
    }
    isDrawing = false;
  }

  function again(): void {
    if (app.solved.value.good === "") return;
    wanted = { text: app.solved.value.good, view: app.view.value };
    void draw();
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
