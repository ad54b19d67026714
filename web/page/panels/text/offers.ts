import { autocompletion, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { hoverTooltip, type EditorView } from "@codemirror/view";
import { h } from "../parts/element.ts";
import { spotAt } from "./path.ts";
import { keys, meaning, values } from "./schema.ts";

/** Offers the keys and words of scenes while somebody types. */
export const offers = autocompletion({ override: [offered], icons: false });

function offered(context: CompletionContext): CompletionResult | null {
  const { state, pos } = context;
  const spot = spotAt(state, pos);
  const isInside = spot.from < pos;
  if (!isInside && !context.explicit) return null;
  const parent = spot.isKey && isInside ? spot.path.slice(0, -1) : spot.path;
  const options = spot.isKey ? keyOptions(parent, isInside) : valueOptions(spot.path);
  return options.length === 0 ? null : { from: spot.from, to: spot.to, options };
}

function keyOptions(path: string[], isWritten: boolean): Completion[] {
  return keys(path).map(({ name, about }) => {
    const word = JSON.stringify(name);
    return { label: word, info: about, apply: isWritten ? word : `${word}: ` };
  });
}

function valueOptions(path: string[]): Completion[] {
  return values(path).map(({ value, about }) => ({ label: JSON.stringify(value), info: about }));
}

/** Says what a key means when the pointer rests on it. */
export const meanings = hoverTooltip((view: EditorView, place, side) => {
  const spot = spotAt(view.state, side < 0 ? place : place + 1);
  const said = spot.isKey && spot.from < spot.to ? meaning(spot.path) : null;
  if (said === null) return null;
  return { pos: spot.from, end: spot.to, above: true, create: () => ({ dom: h("div", { class: "meaning" }, said) }) };
});
