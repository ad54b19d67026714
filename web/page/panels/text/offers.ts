import { autocompletion, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { hoverTooltip, type EditorView } from "@codemirror/view";
import { element } from "../../dom/element.ts";
import { spotAt } from "./path.ts";
import { keys, meaning, values } from "./schema.ts";

/** Offers the keys and words of scenes while somebody types. */
export const offers = autocompletion({ override: [offered], icons: false });

function offered(context: CompletionContext): CompletionResult | null {
  const { state, pos } = context;
  const spot = spotAt(state, pos);
  const isInside = spot.from < pos;
  if (!isInside && !context.explicit) return null;
  const written = state.sliceDoc(spot.from, spot.to);
  // Inside quotes the word alone is offered and put in their place.
  const isQuoted = isInside && written.startsWith('"');
  const path = spot.isKey && isInside ? spot.path.slice(0, -1) : spot.path;
  const options = spot.isKey ? keyOptions(path, isQuoted) : valueOptions(path, isQuoted);
  if (options.length === 0) return null;
  if (!isQuoted) return { from: spot.from, to: spot.to, options };
  const isClosed = written.length > 1 && written.endsWith('"');
  return { from: spot.from + 1, to: isClosed ? spot.to - 1 : spot.to, options, validFor: /^[\w$]*$/ };
}

function keyOptions(path: string[], isQuoted: boolean): Completion[] {
  return keys(path).map(({ name, about }) => ({ label: name, info: about, apply: isQuoted ? name : `${JSON.stringify(name)}: ` }));
}

function valueOptions(path: string[], isQuoted: boolean): Completion[] {
  const found = values(path).filter(({ value }) => !isQuoted || typeof value === "string");
  return found.map(({ value, about }) => ({ label: String(value), info: about, apply: isQuoted ? String(value) : JSON.stringify(value) }));
}

/** Says what a key means when the pointer rests on it. */
export const meanings = hoverTooltip((view: EditorView, place, side) => {
  const spot = spotAt(view.state, side < 0 ? place : place + 1);
  const said = spot.isKey && spot.from < spot.to ? meaning(spot.path) : null;
  if (said === null) return null;
  return { pos: spot.from, end: spot.to, above: true, create: () => ({ dom: element("div", { class: "meaning" }, said) }) };
});
