import { chunks } from "../../dom/chunks.ts";
import { element } from "../../dom/element.ts";
import type { Value } from "../../engine/types.ts";
import { bySubject, named, type Subject } from "../output/subject.ts";
import { shortened } from "./text.ts";
import { say } from "./words.ts";

/** The table of values, with a heading for each link, slider and point; with so many digits, or all (null). */
export function tableOf(values: Value[], digits: number | null): HTMLTableElement {
  const errors = digits === null && values.some((value) => value.error != null);
  const heads = [say("quantity"), say("value"), say("unit"), ...(errors ? [say("error")] : [])];
  const head = element("thead", {}, element("tr", {}, ...heads.map((text) => element("th", { scope: "col" }, text))));
  const table = element("table", { class: "values" }, head);
  const shown = values.map((row) => ({ row, text: digits === null ? row.value : shortened(row.value, digits) }));
  const before = Math.max(0, ...shown.map(({ text }) => wholePart(text)));
  const group = ([subject, rows]: [Subject, typeof shown]): HTMLElement => {
    const title = element("th", { scope: "rowgroup", colspan: heads.length }, named(subject));
    const lines = rows.map(({ row, text }) => lineOf(row, text.padStart(text.length + before - wholePart(text)), errors));
    return element("tbody", {}, element("tr", {}, title), ...lines);
  };
  const groups = chunks(bySubject(shown, ({ row }) => row.quantity), "9rem", group, undefined, emptyGroup);
  table.append(...groups.roots);
  return table;
}

/** A body of a table is as high as what is in it. */
function emptyGroup(): HTMLElement {
  const group = element("tbody");
  group.style.display = "block";
  return group;
}

/** The letters before the decimal point: columns are aligned at it. */
function wholePart(text: string): number {
  return /^-?\d*/.exec(text)![0].length;
}

function lineOf({ name, label, unit, error }: Value, text: string, errors: boolean): HTMLTableRowElement {
  const title = element("th", { scope: "row", title: name });
  title.innerHTML = label;
  const cells = [element("td", { class: "number" }, text), element("td", {}, unit)];
  if (errors) cells.push(element("td", { class: "error" }, error == null ? "" : `± ${error}`));
  return element("tr", {}, title, ...cells);
}
