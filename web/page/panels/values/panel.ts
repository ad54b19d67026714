import type { App, Panel } from "../../app.ts";
import { chunks } from "../../dom/chunks.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import type { Value } from "../../engine/types.ts";
import { copied } from "../../files/clipboard.ts";
import { fileName, saveFile } from "../../files/save.ts";
import { said } from "../../refused.ts";
import { language } from "../../words.ts";
import { keepCurrent } from "../output/current.ts";
import { tableOf } from "./table.ts";
import { aligned, csv } from "./text.ts";
import { say } from "./words.ts";

/** How many digits can be asked for, the usual first; null is all that are certain. */
const DIGITS = [4, 6, null];

/** So much of a line is told: hundreds of drives are listed in one, which nobody reads. */
const LONGEST = 1_000;

/** All rates, velocities and accelerations of the scene's position, and what the mechanism is made of. */
export const values: Panel = {
  id: "values",
  title: () => say("panel_title"),
  mount,
};

function mount(contents: HTMLElement, app: App): void {
  let rows: Value[] = [];
  let shown: Value[] = [];
  const search = worded(element("input", { type: "search", oninput: () => list() }), () => say("find"), "placeholder");
  worded(search, () => say("find"), "aria-label");
  const digits = element("select", { onchange: () => list() });
  const count = element("output", { class: "quiet" });
  const table = element("div", { class: "scroll", tabindex: 0, role: "region" });
  worded(table, () => values.title(), "aria-label");
  const about = element("p", { class: "quiet" });
  const message = element("p", { role: "alert", class: "bad" });
  const structure = element("div", { class: "structure" });
  const warnings = element("ul");
  const warned = element("div", {}, worded(element("h3"), () => say("warnings")), warnings);

  function list(): void {
    const wanted = search.value.trim().toLowerCase();
    shown = rows.filter(({ name, label }) => `${name} ${plain(label)}`.toLowerCase().includes(wanted));
    count.textContent = say("count", { count: shown.length, all: rows.length });
    const digitsWanted = DIGITS[digits.selectedIndex] ?? null;
    about.textContent = say(digitsWanted === null ? "about" : "about_few");
    table.replaceChildren(shown.length === 0 && rows.length > 0 ? say("none") : tableOf(shown, digitsWanted));
  }
  async function copy(): Promise<void> {
    app.tell(say((await copied(aligned(shown))) ? "copied" : "not_copied"));
  }
  const save = (): void => saveFile(`${fileName(app.solved.value.opened?.title)}-values.csv`, csv(shown), "text/csv");

  language.on(() => {
    const chosen = Math.max(0, digits.selectedIndex);
    digits.replaceChildren(...DIGITS.map((n) => element("option", {}, n === null ? say("certain") : say("few", { count: n }))));
    digits.selectedIndex = chosen;
  });
  worded(digits, () => say("digits"), "aria-label");
  const tools = element("div", { class: "tools" }, search, digits, button(() => say("copy"), () => void copy()), button(() => say("save"), save));
  contents.append(
    tools,
    message,
    count,
    table,
    about,
    worded(element("h3"), () => say("groups")),
    structure,
    warned,
  );

  keepCurrent(app, values.id, [app.solved, language], async () => {
    const { good, opened } = app.solved.value;
    if (opened === null) return;
    structure.replaceChildren(...chunks(opened.structure.split("\n"), "1.4rem", (line) => element("div", {}, line.length > LONGEST ? `${line.slice(0, LONGEST)} …` : line)).roots);
    warnings.replaceChildren(...opened.warnings.map((text) => element("li", {}, text)));
    warned.hidden = opened.warnings.length === 0;
    try {
      rows = await app.engine.values(good);
      message.textContent = "";
      list();
    } catch (refused) {
      message.textContent = said(refused);
    }
  });
}

/** A label without its scripts. */
function plain(label: string): string {
  return label.replace(/<[^>]*>/g, "");
}
