/** The operations in their order: what is drawn, in words; and after a check what is right. */
import { element } from "../dom/element.ts";
import { worded } from "../dom/worded.ts";
import { language } from "../words.ts";
import { standing } from "./file.ts";
import type { Model } from "./model.ts";
import { whyOf, type Judging } from "./judging.ts";
import type { JudgedEntry } from "../engine/types.ts";
import { say } from "./words.ts";

const SIGNS: Record<JudgedEntry["verdict"], string> = { right: "✓", wrong: "✗", follows: "↳", unused: "–", undone: "" };

export function list(model: Model, judging: Judging): HTMLElement {
  const items = element("ol");
  const none = worded(element("p", { class: "quiet" }), () => say("list_none"));
  const root = element("section", { class: "list", "aria-labelledby": "board-list-title" }, worded(element("h2", { id: "board-list-title" }), () => say("list")), none, items);
  let chosen = -1;

  function choose(index: number): void {
    chosen = chosen === index ? -1 : index;
    const thing = model.known.value?.things.find(({ entry }) => entry === chosen);
    model.shown.set(thing === undefined ? null : { sheet: thing.sheet, ghost: [thing.path === "" ? { kind: "point", path: `M${thing.at.join(" ")}h0` } : { kind: "line", path: thing.path }], kind: "entry" });
    show();
  }

  function show(): void {
    const known = model.known.value;
    if (known === null) return;
    const until = model.until.value ?? known.did.length;
    const isLooking = model.until.value !== null || model.looked.value !== null;
    // Students count what stands.
    const numbers = standing(model.drawing().did);
    const had = items.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset["entry"] : undefined;
    const rows = known.did.flatMap((entry, index) => {
      if (index >= until || (!isLooking && !entry.stands) || entry.words === "") return [];
      const verdict = judging.verdicts.value?.entries[index];
      const isFirst = judging.verdicts.value?.first_wrong === index;
      const sign = verdict === undefined || !entry.stands ? null : element("span", { class: "sign", role: "img", "aria-label": say(`is_${verdict.verdict}`) }, SIGNS[verdict.verdict]);
      const head = element("button", { type: "button", "data-entry": index, "aria-pressed": String(index === chosen), onclick: () => choose(index) }, element("span", { class: "number" }, entry.stands ? String(numbers.indexOf(index) + 1) : ""), element("span", { class: "what" }, entry.words), sign);
      const more = isFirst || (verdict?.verdict === "wrong" && index === chosen) ? element("p", { class: "why" }, verdict === undefined ? "" : whyOf(verdict)) : null;
      const nowhere = verdict?.verdict === "unused" && entry.stands ? element("p", { class: "nowhere" }, say("is_unused")) : null;
      const back = index === chosen && !isLooking ? element("button", { type: "button", class: "back-to", onclick: () => void model.inTurn(() => model.undoFrom(index)) }, say("back_to_here")) : null;
      return [element("li", { class: `${verdict?.verdict ?? ""}${entry.stands ? "" : " undone"}${isFirst ? " first" : ""}` }, head, more, nowhere, back)];
    });
    none.hidden = rows.length > 0;
    items.replaceChildren(...rows);
    if (had !== undefined) items.querySelector<HTMLElement>(`[data-entry="${had}"]`)?.focus();
    else if (items.lastElementChild !== null) items.lastElementChild.scrollIntoView({ block: "nearest" });
  }

  model.known.on(() => {
    chosen = -1;
    show();
  });
  model.until.on(show);
  judging.verdicts.on(show);
  language.on(show);
  return root;
}
