import { element } from "../../dom/element.ts";

/** Hints for the command line help nobody here. */
const COMMAND = /`kinegon /;

/** What is wrong, and what to try on a line of its own; `where` names the file. */
export function refusal({ message, hint }: { message: string; hint: string | null }, where = ""): Node[] {
  const what = new Text(where === "" ? message : `${where}: ${message}`);
  return hint === null || COMMAND.test(hint) ? [what] : [what, element("small", {}, hint)];
}
