import { element } from "../../dom/element.ts";
import type { PlanPoint } from "../../engine/types.ts";
import { measured } from "../../units.ts";
import type { Place } from "./form.ts";
import { say } from "./words.ts";

interface Events {
  choose(name: string): void;
  typed(name: string, at: Place): void;
  left(): void;
  remove(name: string): void;
}

interface Line {
  root: HTMLElement;
  show(at: Place | undefined, isChosen: boolean): void;
}

/** Points with their places, to be chosen and typed. */
export function pointList(events: Events): { root: HTMLElement; show(points: PlanPoint[], places: Record<string, Place>, chosen: string): void } {
  const root = element("div", { class: "list" });
  let lines = new Map<string, Line>();
  let known = "";

  return {
    root,
    show(points, places, chosen) {
      // Points that stand in the file alone are shown, too.
      const strangers = Object.keys(places).filter((name) => !points.some((point) => point.name === name));
      const all = [...points, ...strangers.map((name) => ({ name, label: name }))];
      const key = all.map((point) => point.name).join("\n");
      if (key !== known) {
        known = key;
        lines = new Map(all.map((point) => [point.name, line(point, strangers.includes(point.name), events)]));
        root.replaceChildren(...[...lines.values()].map((one) => one.root));
      }
      for (const [name, one] of lines) one.show(places[name], name === chosen);
    },
  };
}

/** A point: the button that chooses it, x and y, and the button that takes it away. */
function line(point: PlanPoint, isForeign: boolean, events: Events): Line {
  const choose = element("button", { type: "button", class: "choose" });
  // Only the engine's own labels are markup.
  if (isForeign) choose.textContent = point.label;
  else choose.innerHTML = point.label;
  const name = choose.textContent ?? point.name;
  choose.setAttribute("aria-label", say("place", { name }));
  choose.onclick = () => events.choose(point.name);
  const fields = ([["x", "x_of"], ["y", "y_of"]] as const).map(([axis, saying]) => {
    const input = element("input", { type: "text", inputmode: "decimal", autocomplete: "off", placeholder: axis, "aria-label": say(saying, { name }) });
    input.oninput = typed;
    input.onblur = () => events.left();
    return input;
  });
  const remove = element("button", { type: "button", class: "remove", "aria-label": say("take_away", { name }) }, "×");
  remove.onclick = () => events.remove(point.name);

  const numbers = (): (number | null)[] => fields.map((field) => {
    const value = measured(field.value, "mm");
    return typeof value === "number" ? value : null;
  });

  function typed(): void {
    const [x = null, y = null] = numbers();
    if (x !== null && y !== null) events.typed(point.name, [x, y]);
  }

  return {
    root: element("div", { class: "place" }, choose, ...fields, remove),
    show(at, isChosen) {
      choose.setAttribute("aria-pressed", String(isChosen));
      remove.disabled = at === undefined;
      const isTyping = fields.some((field) => field === document.activeElement);
      if (isTyping && (at === undefined || numbers().every((value, axis) => value === at[axis]))) return;
      fields.forEach((field, axis) => (field.value = at === undefined ? "" : String(at[axis])));
    },
  };
}
