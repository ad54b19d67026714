import { element } from "../../../dom/element.ts";
import { SHEETS, type Panel } from "../../../engine/types.ts";
import { called } from "../../../sheets.ts";
import { say, type Saying } from "./words.ts";

/** How a point stands. */
export type State = "none" | "printed" | "out" | "right" | "off" | "open" | "proposed";

/** A point in the bar. */
export interface Entry {
  key: string;
  plan: Panel;
  label: string;
  state: State;
}

const SIGNS: Record<State, string> = { none: "", printed: "•", out: "–", right: "✓", off: "✗", open: "?", proposed: "◌" };

/** A label of the engine without its scripts. */
export function plain(label: string): string {
  const holder = document.createElement("template");
  holder.innerHTML = label;
  return holder.content.textContent ?? "";
}

/** The points in the order of the construction, to be chosen. */
export function pointsBar(choose: (key: string) => void): { root: HTMLElement; show(entries: Entry[], chosen: string): void } {
  const root = element("div", { class: "chips" });
  let known = "";
  let chips = new Map<string, HTMLButtonElement>();

  function build(entries: Entry[]): void {
    chips = new Map();
    const plans = [...new Set(entries.map(({ plan }) => plan))];
    const groups = plans.map((plan) => {
      const group = element("div", { role: "group", "aria-label": say("points", { plan: called(plan, "name") }) });
      if (plans.length > 1) group.append(element("span", { class: "of", "aria-hidden": "true" }, SHEETS.find(({ key }) => key === plan)!.vector));
      for (const { key, label, plan: of } of entries) {
        if (of !== plan) continue;
        const chip = element("button", { type: "button", "data-key": key });
        const name = element("span", { class: "name" });
        name.innerHTML = label;
        chip.append(name, element("span", { class: "sign" }));
        chip.onclick = () => choose(key);
        chips.set(key, chip);
        group.append(chip);
      }
      return group;
    });
    root.replaceChildren(...groups);
  }

  return {
    root,
    show(entries, chosen) {
      const now = JSON.stringify([entries.map(({ key, label }) => [key, label]), say("title")]);
      if (now !== known) build(entries);
      known = now;
      for (const { key, label, state } of entries) {
        const chip = chips.get(key)!;
        const isNew = chip.getAttribute("aria-pressed") !== "true" && key === chosen;
        chip.dataset["state"] = state;
        chip.setAttribute("aria-pressed", String(key === chosen));
        chip.setAttribute("aria-label", `${plain(label)}: ${say(`state_${state}` as Saying)}`);
        chip.querySelector(".sign")!.textContent = SIGNS[state];
        if (isNew) chip.scrollIntoView({ block: "nearest", inline: "center" });
      }
    },
  };
}
