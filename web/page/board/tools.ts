/** The tools: for each the entry that it writes, as slots that the list and the canvas fill alike. The rubber writes what it needs of others (model.ts). */
import type { Entry } from "./file.ts";

/** In the order of their buttons. */
export const TOOLS = ["lay_off", "line", "join", "cross", "mark", "like", "measure", "compute", "solve", "rub"] as const;
export type Tool = (typeof TOOLS)[number];

/** The letters that choose them. */
export const KEY_OF: Record<Tool, string> = { lay_off: "d", line: "s", join: "r", cross: "p", mark: "k", like: "i", measure: "m", compute: "=", solve: "e", rub: "x" };

/** What a slot takes: a point of the sheet that is drawn on, one of the scheme, a line, what has a direction, a way to lie to it, a formula, … */
export type Takes = "sheet" | "point" | "scheme" | "line" | "direction" | "how" | "angle" | "formula" | "formulas" | "point_name" | "line_name" | "number_name" | "names" | "sense" | "made" | "base";

export interface Slot {
  /** Its blank in the tool's sentence. */
  readonly blank: string;
  readonly takes: Takes;
  /** Whether the entry may do without it. */
  readonly optional?: boolean;
  get(entry: Entry): string;
  set(entry: Entry, value: string): Entry;
}

/** A key of the entry itself. */
function key(name: string, takes: Takes, blank = name, optional = false): Slot {
  return {
    blank,
    takes,
    optional,
    get: (entry) => (typeof entry[name] === "string" ? entry[name] : ""),
    set(entry, value) {
      const { [name]: _, ...rest } = entry;
      return value === "" && optional ? rest : { ...entry, [name]: value };
    },
  };
}

/** A place in a list of the entry. */
function at(name: string, index: number, takes: Takes, blank: string): Slot {
  const all = (entry: Entry): string[] => (Array.isArray(entry[name]) ? (entry[name] as unknown[]).map(String) : []);
  return {
    blank,
    takes,
    get: (entry) => all(entry)[index] ?? "",
    set(entry, value) {
      const next = all(entry);
      while (next.length <= index) next.push("");
      next[index] = value;
      return { ...entry, [name]: next };
    },
  };
}

/** A list that is written in one box, its parts apart by a sign. */
function listed(name: string, takes: Takes, sign: string): Slot {
  return {
    blank: name,
    takes,
    get: (entry) => (Array.isArray(entry[name]) ? (entry[name] as unknown[]).join(sign) : ""),
    set: (entry, value) => ({ ...entry, [name]: value.split(sign.trim() === "" ? /\n/ : sign.trim()).map((part) => part.trim()).filter(Boolean) }),
  };
}

/** The sense of a rate that has its own sign: it is chosen, and the entry says none. */
export const AS_IT_COMES = "as_it_comes";

export const HOWS = ["normal", "parallel", "turned", "angle"] as const;
type How = (typeof HOWS)[number];

const alongOf = (entry: Entry): Record<string, unknown> => (typeof entry["along"] === "object" && entry["along"] !== null ? (entry["along"] as Record<string, unknown>) : {});
export const howOf = (entry: Entry): How => HOWS.find((how) => how in alongOf(entry)) ?? "normal";

/** How something lies, with nothing to lie to; what it lies to stays between right angles and parallels. */
function along(how: How, before: Entry = {}): Entry {
  if (how === "turned") return { turned: ["", ""], base: "" };
  const reference = alongOf(before)[howOf(before)];
  return { [how]: how !== "angle" && howOf(before) !== "angle" && typeof reference === "string" ? reference : "" };
}

const HOW: Slot = { blank: "how", takes: "how", get: howOf, set: (entry, how) => ({ ...entry, along: along(how as How, entry) }) };
const REFERENCE: Slot = {
  blank: "reference",
  takes: "direction",
  get: (entry) => String(alongOf(entry)[howOf(entry)] ?? ""),
  set: (entry, value) => ({ ...entry, along: { [howOf(entry)]: value } }),
};
const ANGLE: Slot = {
  ...REFERENCE,
  takes: "angle",
  set: (entry, value) => ({ ...entry, along: { angle: value.trim() !== "" && Number.isFinite(Number(value)) ? Number(value) : value } }),
};
/** Turned by the angle from one direction to another, beginning at a third: the rays of similar triangles. */
const TURNED: Slot[] = [at("turned", 0, "direction", "turned_from"), at("turned", 1, "direction", "turned_to"), key("base", "base")].map((slot) => ({
  ...slot,
  get: (entry) => slot.get(alongOf(entry)),
  set: (entry, value) => ({ ...entry, along: slot.set(alongOf(entry), value) }),
}));
const directionOf = (entry: Entry): Slot[] => [HOW, ...(howOf(entry) === "turned" ? TURNED : [howOf(entry) === "angle" ? ANGLE : REFERENCE])];
const ON = key("on", "sheet");

/** A thing by its sheet and its name: points of two plans have the same names. */
export const madeOf = (sheet: string, name: string): string => `${sheet}/${name}`;
const MADE: Slot = {
  blank: "name",
  takes: "made",
  get: ({ on, rub }) => (typeof rub !== "string" || rub === "" ? "" : madeOf(String(on ?? ""), rub)),
  set: (_, value) => (value === "" ? { rub: "" } : { rub: value.slice(value.indexOf("/") + 1), on: value.slice(0, value.indexOf("/")) }),
};

/** The slots of an entry, in the order in which they are filled; the name of what it makes comes last. */
export function slotsOf(tool: Tool, entry: Entry): Slot[] {
  const direction = directionOf(entry);
  switch (tool) {
    case "lay_off":
      return [ON, key("size", "formula"), key("from", "point"), ...direction, key("lay_off", "point_name", "name")];
    case "line":
      return [ON, ...direction, key("through", "point"), key("line", "line_name", "name")];
    case "join":
      return [ON, at("points", 0, "point", "first"), at("points", 1, "point", "second"), key("join", "line_name", "name")];
    case "cross":
      return [at("of", 0, "line", "first"), at("of", 1, "line", "second"), key("cross", "point_name", "name")];
    case "mark":
      return [ON, key("mark", "point_name", "name")];
    case "like":
      return [ON, ...[0, 1, 2].map((index) => at("points", index, "scheme", ["one", "two", "three"][index]!)), at("ends", 0, "point", "first"), at("ends", 1, "point", "second"), key("like", "point_name", "name")];
    case "measure":
      return [ON, key("from", "point"), key("to", "point"), key("measure", "number_name", "name")];
    case "compute":
      return [key("compute", "number_name", "name"), key("as", "formula"), key("sense", "sense", "sense", true)];
    case "solve":
      return [listed("solve", "names", ","), listed("equations", "formulas", "\n")];
    case "rub":
      return [MADE];
  }
}

/** An entry with what it lies to turned by a quarter. */
export function turned(tool: Tool, entry: Entry): Entry {
  const slot = slotsOf(tool, entry).find(({ takes }) => takes === "how");
  return slot === undefined ? entry : slot.set(entry, howOf(entry) === HOWS[0] ? HOWS[1] : HOWS[0]);
}

/** An entry of which nothing is said yet; how it lies to a direction is kept from the one before with the same tool. */
export function begun(tool: Tool, before: Entry = {}): Entry {
  const how = tool === "line" || tool === "lay_off" ? { along: along(howOf(before)) } : {};
  return { [tool]: tool === "solve" ? [] : "", ...how };
}

/** The slot that is to be filled next; none where all is said but perhaps a name that the board gives by itself. */
export function lacking(tool: Tool, entry: Entry): Slot | undefined {
  // A line by eye goes through no point that has a name.
  const isFree = tool === "line" && entry["drawn"] !== undefined;
  const isNeeded = ({ optional, takes }: Slot): boolean => !optional && takes !== "line_name" && takes !== "sheet" && !(tool === "measure" && takes === "number_name") && !(isFree && takes === "point");
  return slotsOf(tool, entry).find((slot) => isNeeded(slot) && slot.get(entry).trim() === "");
}
