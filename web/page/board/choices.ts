/** What there is to choose from for a slot, of what the engine says of the drawing. */
import type { Board } from "../engine/types.ts";
import { called } from "../sheets.ts";
import type { Entry } from "./file.ts";
import { AS_IT_COMES, HOWS, madeOf, type Takes } from "./tools.ts";
import { say } from "./words.ts";

/** Senses of a rate; the last is the one that its number has. */
const SENSES = ["ccw", "cw", AS_IT_COMES] as const;

/** A name of the file and what is shown of it. */
export type Choice = [value: string, shown: string];

/** What a box offers; `on` is the sheet that is drawn on. */
export function choicesOf(takes: Takes, known: Board, on: string): Choice[] {
  const things = (kinds: string[], isThere: (sheet: string) => boolean): Choice[] => known.things.filter(({ kind, sheet }) => kinds.includes(kind) && isThere(sheet)).map(({ name, words }) => [name, words]);
  switch (takes) {
    case "sheet":
      return known.sheets.map(({ sheet }) => [sheet, called(sheet, "name")]);
    case "point":
      return things(["point"], (sheet) => sheet === on);
    case "scheme":
      return things(["point"], (sheet) => sheet === "scheme");
    case "line":
      return things(["line"], () => true);
    case "direction":
      return things(["link", "guide", "line"], () => true);
    case "made":
      return known.things.filter(({ entry }) => entry !== null).map(({ sheet, name, words }) => [madeOf(sheet, name), `${called(sheet, "short")}: ${words}`]);
    case "how":
      return HOWS.map((how) => [how, say(how)]);
    case "sense":
      return [["", "…"], ...SENSES.map((sense): Choice => [sense, say(sense)])];
    default:
      return [];
  }
}

/** Something to press in place of writing: `label` is the engine's HTML. */
export interface Chip {
  name: string;
  label: string;
  value: string;
}

/** Numbers for a formula, names for what an entry makes. */
export function chipsOf(takes: Takes, known: Board, entry: Entry, on: string): Chip[] {
  // What was found last comes first.
  if (takes === "formulas") return [...unknowns(known, entry), ...chipsOf("formula", known, entry, on)];
  if (takes === "formula") return known.numbers.toSorted((a, b) => (b.entry ?? -1) - (a.entry ?? -1)).map(({ name, label, value, unit }) => ({ name, label, value: `${value} ${unit}`.trim() }));
  if (takes === "sense") return SENSES.map((sense) => ({ name: sense, label: { ccw: "↺", cw: "↻", as_it_comes: "±" }[sense], value: say(sense) }));
  const kind = takes === "point_name" ? "point" : takes === "number_name" || takes === "names" ? "number" : "";
  if (kind === "") return [];
  const sheet = takes === "point_name" ? sheetOf(known, entry, on) : null;
  const own = takes === "point_name" ? known.free.point : takes === "number_name" ? known.free.number : "";
  const offered = known.names.filter((one) => one.kind === kind && !one.is_made && (sheet === null || one.sheet === sheet)).map(({ name, label }) => ({ name, label, value: "" }));
  return own === "" ? offered : [...offered, { name: own, label: own, value: say("own") }];
}

/** What is solved for. */
function unknowns(known: Board, entry: Entry): Chip[] {
  const all = Array.isArray(entry["solve"]) ? (entry["solve"] as unknown[]).map(String) : [];
  return all.map((name) => ({ name, label: known.names.find((one) => one.kind === "number" && one.name === name)?.label ?? "", value: "" })).filter(({ label }) => label !== "");
}

/** A crossing is on the sheet of its lines. */
function sheetOf(known: Board, entry: Entry, on: string): string {
  const [first] = Array.isArray(entry["of"]) ? (entry["of"] as string[]) : [];
  return known.things.find(({ kind, name }) => kind === "line" && name === first)?.sheet ?? on;
}
