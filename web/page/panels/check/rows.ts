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

  function group(title: string, of: FormRow[]): HTMLElement[] {
    if (of.length === 0) return [];
    const made = of.map((found) => {
      const one = row(found, events);
      all.set(found.name, one);
      return one.root;
    });
    return [element("fieldset", {}, element("legend", {}, title), ...made)];
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
    const inputs = [...all.values()].map((one) => one.input);
    const next = inputs[inputs.indexOf(event.target) + (event.shiftKey ? -1 : 1)];
    if (next === undefined) event.target.blur();
    else next.select();
    next?.focus();
    event.preventDefault();
  };

  return {
    root,
    build({ rows: boxes }) {
      all = new Map();
      const asked = boxes.filter((box) => box.is_asked);
      root.replaceChildren(
        ...SHEETS.flatMap(({ key }) => group(called(key, "from"), asked.filter((box) => box.panel === key))),
        ...group(say("further"), boxes.filter((box) => !box.is_asked)),
        strays,
      );
    },
    show(file, judged) {
      for (const [name, one] of all) {
        const own = judged.get(name);
        one.show(file, own?.fromPoints ?? null);
        one.judge(own?.verdict ?? null);
      }
      const unknown = filledNames(file).filter((name) => !all.has(name));
      strays.hidden = unknown.length === 0;
      const legend = element("legend", {}, say("unknown"));
      strays.replaceChildren(legend, ...unknown.map((name) => stray(name, judged.get(name) ?? { verdict: null, fromPoints: null })));
    },
    firstOff() {
      return root.querySelector<HTMLElement>('input[aria-invalid="true"]');
    },
  };
}
