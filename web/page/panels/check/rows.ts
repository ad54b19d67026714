import { chunks } from "../../dom/chunks.ts";
import { element } from "../../dom/element.ts";
import { SHEETS, type Form, type FormRow } from "../../engine/types.ts";
import { called } from "../../sheets.ts";
import { filledNames, type FormFile } from "./form.ts";
import type { Judged } from "./judged.ts";
import { row, type Row, type RowEvents } from "./row.ts";
import { showVerdict } from "./verdict.ts";
import { say } from "./words.ts";

export interface Rows {
  root: HTMLElement;
  build(form: Form): void;
  show(file: FormFile, judged: Map<string, Judged>): void;
  /** The first field whose value is off or not understood. */
  firstOff(): HTMLElement | null;
}

/** The boxes of the form by sheets, then what else stands in it. */
export function rows(events: RowEvents & { remove(name: string): void }): Rows {
  const root = element("div", { class: "rows" });
  const strays = element("fieldset", { class: "strays" });
  let all = new Map<string, Row>();
  /** Builds the row of each name. */
  let reach = new Map<string, () => void>();
  /** The first name whose value is off. */
  let off = "";
  let again = (): void => {};

  function group(title: string, of: FormRow[]): HTMLElement[] {
    if (of.length === 0) return [];
    const build = (found: FormRow): HTMLElement => {
      const one = row(found, events);
      all.set(found.name, one);
      return one.root;
    };
    const made = chunks(of, "2.4rem", build, () => again());
    of.forEach(({ name }, index) => reach.set(name, () => made.reach(index)));
    return [element("fieldset", {}, element("legend", {}, title), ...made.roots)];
  }

  /** A value without a box: its name, why, and a button that removes it. */
  function stray(name: string, { verdict }: Judged): HTMLElement {
    const place = element("span", { class: "verdict" });
    showVerdict(place, verdict);
    const button = element("button", { type: "button" }, say("remove", { name }));
    button.onclick = () => events.remove(name);
    return element("div", { class: "row stray" }, element("code", {}, name), place, button);
  }

  root.onkeydown = (event) => {
    if (event.key !== "Enter" || !(event.target instanceof HTMLInputElement)) return;
    const names = [...reach.keys()];
    const to = names[names.findIndex((name) => all.get(name)?.input === event.target) + (event.shiftKey ? -1 : 1)];
    reach.get(to ?? "")?.();
    const next = all.get(to ?? "")?.input;
    if (next === undefined) event.target.blur();
    else next.select();
    next?.focus();
    event.preventDefault();
  };

  return {
    root,
    build({ rows: boxes }) {
      all = new Map();
      reach = new Map();
      const asked = boxes.filter((box) => box.is_asked);
      root.replaceChildren(
        ...SHEETS.flatMap(({ key }) => group(called(key, "from"), asked.filter((box) => box.panel === key))),
        ...group(say("further"), boxes.filter((box) => !box.is_asked)),
        strays,
      );
    },
    show(file, judged) {
      again = () => this.show(file, judged);
      off = [...reach.keys()].find((name) => ["off", "fault"].includes(judged.get(name)?.verdict?.kind ?? "")) ?? "";
      for (const [name, one] of all) {
        const own = judged.get(name);
        one.show(file, own?.fromPoints ?? null, own?.is ?? null);
        one.judge(own?.verdict ?? null);
      }
      const unknown = filledNames(file).filter((name) => !reach.has(name));
      strays.hidden = unknown.length === 0;
      const legend = element("legend", {}, say("unknown"));
      strays.replaceChildren(legend, ...unknown.map((name) => stray(name, judged.get(name) ?? { verdict: null, fromPoints: null, is: null })));
    },
    firstOff() {
      reach.get(off)?.();
      return all.get(off)?.input ?? null;
    },
  };
}
