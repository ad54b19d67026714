import type { App } from "../app.ts";
import type { Refused } from "../engine/types.ts";
import { newest } from "./newest.ts";

/** Keeps `solved` that of the present text; while one text is being solved only the newest of the later ones waits. */
export function solving(app: App): void {
  const solver = newest(async (text: string) => {
    try {
      const opened = await app.engine.open(text);
      app.solved.set({ text, opened, good: text, refused: null });
    } catch (refused) {
      app.solved.set({ ...app.solved.value, text, refused: refused as Refused });
    }
  });
  app.history.now.on(({ text }) => {
    if (text !== app.solved.value.text || !solver.isIdle()) solver.want(text);
  });
}
