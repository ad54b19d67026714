import type { Shown } from "../app.ts";
import type { Refused } from "../engine/types.ts";
import { language } from "../words.ts";
import { newest } from "./newest.ts";

/** Does it now, or when the number that is being typed is whole, if the text is still the same then. */
function whenTyped(app: Shown, text: string, act: () => void): void {
  if (!app.typing.value) return act();
  const end = app.typing.on((is) => {
    if (is) return;
    end();
    if (app.history.now.value.text === text) act();
  });
}

/** The good text, as soon as there is one, for of a scene nothing can be asked before it is solved; rejects with why there is none. */
export function goodText(app: Pick<Shown, "solved">): Promise<string> {
  return new Promise((done, fail) => {
    const end = app.solved.on(({ good, refused }) => {
      if (good === "" && refused === null) return;
      if (good === "") fail(refused);
      else done(good);
      // The first call comes before there is an end to it.
      queueMicrotask(() => end());
    });
  });
}

/** Keeps `solved` that of the present text; while one text is being solved only the newest of the later ones waits. */
export function solving(app: Shown): void {
  const solver = newest(async (text: string) => {
    try {
      const opened = await app.engine.open(text);
      app.solved.set({ text, opened, good: text, refused: null });
    } catch (refused) {
      whenTyped(app, text, () => app.solved.set({ ...app.solved.value, text, refused: refused as Refused }));
    }
  });
  // Steps and warnings are told in the page's language.
  language.on(() => app.solved.value.opened !== null && solver.want(app.history.now.value.text));
  app.history.now.on(({ text }) => {
    if (text !== app.solved.value.text || !solver.isIdle()) solver.want(text);
  });
}
