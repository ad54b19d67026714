import type { App } from "../app.ts";
import type { Refused } from "../engine/types.ts";

/** Keeps `solved` that of the present text; while one text is being solved only the newest of the later ones waits. */
export function solving(app: App): void {
  let wanted: string | null = null;
  let isSolving = false;

  async function solve(): Promise<void> {
    if (isSolving) return;
    isSolving = true;
    while (wanted !== null) {
      const text = wanted;
      wanted = null;
      try {
        const opened = await app.engine.open(text);
        app.solved.set({ text, opened, good: text, refused: null });
      } catch (refused) {
        app.solved.set({ ...app.solved.value, text, refused: refused as Refused });
      }
    }
    isSolving = false;
  }

  app.history.now.on(({ text }) => {
    if (text === app.solved.value.text && wanted === null && !isSolving) return;
    wanted = text;
    void solve();
  });
}
