import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { radios } from "../dom/radios.ts";
import type { Store } from "../state/storage.ts";
import { language, type Language } from "../words.ts";
import { redo, undo } from "./keys.ts";

/** Undo, redo, the three hands, paper, language. */
export function toolbar(app: App, store: Store): void {
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
  for (const skip of document.querySelectorAll<HTMLElement>("[data-skip]")) skip.onclick = () => skipTo(skip.dataset["skip"] ?? "");
  for (const group of document.querySelectorAll<HTMLElement>("[role=radiogroup]")) radios(group);

  const select = byId<HTMLSelectElement>("language");
  language.on((now) => (select.value = now));
  select.onchange = () => {
    language.set(select.value as Language);
    store.prefer("language", select.value);
  };
}

/** Puts the focus on the first of these that can be seen. */
function skipTo(selector: string): void {
  const found = [...document.querySelectorAll<HTMLElement>(selector)].find((place) => place.getClientRects().length > 0);
  found?.focus();
}
