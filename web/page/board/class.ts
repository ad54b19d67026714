/** The drawings of a class beside the board: which operation was wrong first, how often, and how long each took; a name opens its drawing. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { said } from "../refused.ts";
import { newest } from "../state/newest.ts";
import { goodText } from "../state/solving.ts";
import { language } from "../words.ts";
import { drawingOf } from "./file.ts";
import { soFar } from "./judging.ts";
import type { Model } from "./model.ts";
import { say } from "./words.ts";

/** A drawing that was handed in. */
export interface HandedIn {
  name: string;
  text: string;
}

interface Judged extends HandedIn {
  /** What is found of it first, in words: the group that it belongs to. */
  found: string;
  /** Right ones come last, and what was not understood after them. */
  rank: number;
  minutes: number | null;
}

async function judged(app: App, handed: HandedIn): Promise<Judged> {
  const { did = [], name } = drawingOf(handed.text) ?? {};
  const last = Number(did.at(-1)?.["t"]);
  const own = { ...handed, name: typeof name === "string" && name !== "" ? name : handed.name.replace(/\.json$/i, ""), minutes: Number.isFinite(last) ? Math.ceil(last / 60_000) : null };
  try {
    const judged = await app.engine.board_judge(await goodText(app), handed.text);
    const { entries, first_wrong: first, is_complete: isComplete } = judged;
    const wrong = first == null ? undefined : entries[first];
    if (wrong === undefined) return { ...own, found: soFar(judged, did), rank: isComplete ? 2 : 1 };
    return { ...own, found: wrong.done ?? wrong.says ?? "", rank: 0 };
  } catch (refused) {
    return { ...own, found: said(refused), rank: 3 };
  }
}

export function classList(app: App, model: Model): HTMLElement {
  const title = element("h2", { id: "board-class-title" });
  const groups = element("div");
  const away = element("button", { type: "button", class: "back-to", onclick: () => app.handed.set([]) });
  const root = element("section", { class: "class", id: "board-class", "aria-labelledby": title.id, hidden: true }, title, groups, away);
  let all: Judged[] = [];

  function show(): void {
    title.textContent = say("class", { count: all.length });
    away.textContent = say("class_away");
    const found = new Map<string, Judged[]>();
    for (const one of all) found.set(one.found, [...(found.get(one.found) ?? []), one]);
    const rows = [...found].sort(([, one], [, two]) => one[0]!.rank - two[0]!.rank || two.length - one.length);
    groups.replaceChildren(...rows.map(([words, of]) => element("div", { class: `group ${of[0]!.rank === 0 ? "wrong" : ""}` },
      element("p", {}, element("b", {}, `${of.length} ×`), ` ${words}`),
      element("ul", {}, ...of.map((one) => element("li", {}, opens(one)))))));
  }

  function opens(one: Judged): HTMLButtonElement {
    const isOpen = model.looked.value === one.text;
    const made = element("button", { type: "button", "aria-pressed": String(isOpen), onclick: () => open(isOpen ? null : one.text) }, one.name);
    if (one.minutes !== null) made.append(element("small", {}, say("class_minutes", { minutes: one.minutes })));
    return made;
  }

  /** Looks at a drawing, all of it, with the slider that goes back in it; at none, the own again. */
  function open(text: string | null): void {
    model.looked.set(text);
    model.until.set(text === null ? null : (drawingOf(text)?.did.length ?? 0));
  }

  const judging = newest(async (handed: readonly HandedIn[]) => {
    all = [];
    root.hidden = handed.length === 0;
    for (const each of handed) all.push(await judged(app, each));
    show();
  });
  app.handed.on((handed) => {
    open(null);
    judging.want(handed);
  });
  model.looked.on(show);
  language.on(() => judging.want(app.handed.value));
  return root;
}
