/** What there is to choose from for a slot, of what the engine says of the drawing. */
import type { Board } from "../engine/types.ts";
import { called } from "../sheets.ts";
import type { Entry } from "./file.ts";
import { HOWS, madeOf, type Takes } from "./tools.ts";
import { say } from "./words.ts";

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
      return [["", say("sense_none")], ["ccw", say("ccw")], ["cw", say("cw")]];
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
  if (takes === "formula" || takes === "formulas") return known.numbers.toSorted((a, b) => (b.entry ?? -1) - (a.entry ?? -1)).map(({ name, label, value, unit }) => ({ name, label, value: `${value} ${unit}`.trim() }));
  const kind = takes === "point_name" ? "point" : takes === "number_name" || takes === "names" ? "number" : "";
  if (kind === "") return [];
  const sheet = takes === "point_name" ? sheetOf(known, entry, on) : null;
  const own = takes === "point_name" ? known.free.point : takes === "number_name" ? known.free.number : "";
  const offered = known.names.filter((one) => one.kind === kind && !one.is_made && (sheet === null || one.sheet === sheet)).map(({ name, label }) => ({ name, label, value: "" }));
  return own === "" ? offered : [...offered, { name: own, label: own, value: say("own") }];
}

/** A crossing is on the sheet of its lines. */
function sheetOf(known: Board, entry: Entry, on: string): string {
  const [first] = Array.isArray(entry["of"]) ? (entry["of"] as string[]) : [];
  return known.things.find(({ kind, name }) => kind === "line" && name === first)?.sheet ?? on;
}
