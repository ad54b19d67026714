/** What becomes of an entry before it is written. */
import type { Board } from "../engine/types.ts";
import { standing, type Entry } from "./file.ts";
import { AS_IT_COMES, slotsOf, type Tool } from "./tools.ts";

/** Whether a number has a sense: the rate of a link. */
export const isTurning = (name: unknown, { names }: Pick<Board, "names">): boolean => names.some((known) => known.is_turning && known.name === name);

/** The entry as the file has it: what is chosen of a sense that it does not need, or of the sign that the number has itself, is not said. */
export function written(entry: Entry, board: Pick<Board, "names">): Entry {
  const { sense, ...rest } = entry;
  return sense === undefined || (sense !== AS_IT_COMES && isTurning(entry["compute"], board)) ? entry : rest;
}

/** The entry with the name that the board gives: to lines always, to what is measured that of its ends. */
export function named(tool: Tool, entry: Entry, { free, numbers }: Pick<Board, "free" | "numbers">): Entry {
  const slot = slotsOf(tool, entry).find(({ blank }) => blank === "name");
  if (slot === undefined || slot.get(entry).trim() !== "") return entry;
  if (slot.takes === "line_name") return slot.set(entry, free.line);
  if (tool !== "measure") return entry;
  const both = `${String(entry["from"])}${String(entry["to"])}`.replace(/[^A-Za-z0-9_]/g, "");
  return slot.set(entry, both !== "" && !numbers.some(({ name }) => name === both) ? both : free.number);
}

/** Takes back what made a thing and all that hangs on it; what came after it and does not is written again. Null where there is no such thing. */
export function rubbed({ rub, on }: Entry, did: readonly Entry[], { things, did: known }: Pick<Board, "things" | "did">): Entry[] | null {
  const first = things.find(({ name, sheet, entry }) => name === rub && entry !== null && (on === undefined || sheet === on))?.entry;
  if (first == null) return null;
  const after = standing(did).filter((index) => index >= first);
  const gone = new Set([first]);
  for (const index of after) if (known[index]?.needs.some((need) => gone.has(need))) gone.add(index);
  return [{ undo: after.length }, ...after.filter((index) => !gone.has(index)).map((index) => did[index]!)];
}
