import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { radios } from "../dom/radios.ts";
import { language, LANGUAGES, type Language } from "../words.ts";
import { redo, undo } from "./keys.ts";

/** Undo, redo, the three hands, paper, language. */
export function toolbar(app: App): void {
  byId("undo").onclick = () => undo(app);
  byId("redo").onclick = () => redo(app);
  app.history.canUndo.on((can) => (byId<HTMLButtonElement>("undo").disabled = !can));
  app.history.canRedo.on((can) => (byId<HTMLButtonElement>("redo").disabled = !can));

  const hand = (shaping: boolean) => (): void => {
    app.shaping.set(shaping);
    app.building.set(false);
  };
  byId("hand-move").onclick = hand(false);
  byId("hand-shape").onclick = hand(true);
  byId("hand-build").onclick = () => app.building.set(!app.student.value);
  const mark = (): void => {
    const [shaping, building] = [app.shaping.value, app.building.value];
    for (const [id, is] of [["hand-move", !shaping && !building], ["hand-shape", shaping && !building], ["hand-build", building]] as const) {
      byId(id).setAttribute("aria-checked", String(is));
      byId(id).tabIndex = is ? 0 : -1;
    }
  };
  app.shaping.on(mark);
  app.building.on(mark);
  byId("as-paper").onclick = () => app.paper.set(!app.paper.value);
  app.paper.on((is) => byId("as-paper").setAttribute("aria-pressed", String(is)));
  for (const group of document.querySelectorAll<HTMLElement>("[role=radiogroup]")) radios(group);

  const select = byId<HTMLSelectElement>("language");
  language.on((now) => (select.value = now));
  select.onchange = () => void changeLanguage(app, select.value as Language);
  app.solved.on(({ opened }) => {
    const own: unknown = opened?.scene["figure"]?.["language"] ?? "en";
    const known = LANGUAGES.find((each) => each === own);
    if (opened !== null && known !== undefined) language.set(known);
  });
}

/** The scene's own key chooses the language. */
async function changeLanguage(app: App, to: Language): Promise<void> {
  try {
    const text = await app.engine.edit(app.history.now.value.text, [{ set: ["figure", "language"], value: to }]);
    app.history.change({ text });
  } catch {
    // A text that is no scene has no key for it; the page changes all the same.
    language.set(to);
  }
}
