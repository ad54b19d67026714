import { chunks } from "../../dom/chunks.ts";
import { element } from "../../dom/element.ts";
import type { Quantity } from "../../engine/types.ts";
import { bySubject, named, type Subject } from "../output/subject.ts";

/** Symbols in place of the names of quantities, where there are better ones. */
const SYMBOLS: Record<string, [string, string?]> = {
  angle: ["φ"],
  omega: ["ω"],
  alpha: ["α"],
  rpm: ["n"],
  position: ["s"],
  v_r: ["v", "r"],
  a_r: ["a", "r"],
  a_c: ["a", "c"],
};

/** Names to tick, grouped by link, slider and point; `toggle` hears of each change, `built` of those that are built when they come near. */
export function choices(all: Quantity[], chosen: string[], toggle: (name: string, on: boolean) => void, built: () => void): HTMLElement {
  const group = ([subject, members]: [Subject, Quantity[]]): HTMLElement => {
    const boxes = members.map((one) => chip(one.name, symbol(one, subject.name), chosen.includes(one.name), toggle));
    const title = named(subject);
    return element("div", { role: "group", "aria-label": title }, element("span", {}, title), element("div", { class: "chips" }, ...boxes));
  };
  // What is built later is ticked as the rest is.
  const made = chunks(bySubject(all, (one) => one), "2.6rem", group, built);
  return element("div", { class: "choices" }, ...made.roots);
}

/** Points to tick. */
export function points(names: string[], chosen: string[], toggle: (name: string, on: boolean) => void): HTMLElement {
  return element("div", { class: "chips" }, ...names.map((name) => chip(name, [name], chosen.includes(name), toggle)));
}

/** Ticks these names, and no others. */
export function ticked(root: HTMLElement, chosen: string[]): void {
  for (const box of root.querySelectorAll("input")) box.checked = chosen.includes(box.value);
}

function chip(name: string, shown: (Node | string)[], on: boolean, toggle: (name: string, on: boolean) => void): HTMLLabelElement {
  const box = element("input", { type: "checkbox", value: name, checked: on, "aria-label": name, onchange: () => toggle(name, box.checked) });
  return element("label", { class: "chip", title: name }, box, element("span", {}, ...shown));
}

/** A quantity's symbol, where its subject stands beside: `ω` for `omega(3)`, `v` for `v(D)`. */
function symbol({ name, head, inside, part }: Quantity, subject: string): (Node | string)[] {
  if (inside !== subject) return [name];
  const [letter, index] = SYMBOLS[head] ?? [head];
  const symbol = element("i", {}, letter);
  return index === undefined ? [symbol, part] : [symbol, element("sub", {}, index), part];
}
