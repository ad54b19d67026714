import { element } from "../../dom/element.ts";
import { radios } from "../../dom/radios.ts";
import type { Sense } from "./sense.ts";
import { say } from "./words.ts";

/** Two buttons of which one is chosen: the sense of a rotation, or of a slide along its guide. */
export function senseButtons(name: string, turns: boolean, choose: (sense: Sense) => void): { root: HTMLElement; show(sense: Sense): void } {
  const button = (sense: Sense, sign: string, words: string): HTMLButtonElement => {
    const made = element("button", { type: "button", role: "radio", "aria-label": words, title: words }, sign);
    made.onclick = () => {
      show(sense);
      choose(sense);
    };
    return made;
  };
  const plus = turns ? button("+", "↺", say("ccw")) : button("+", "+", say("along"));
  const minus = turns ? button("-", "↻", say("cw")) : button("-", "−", say("against"));
  const root = element("span", { class: "sense", role: "radiogroup", "aria-label": say("sense_of", { name }) }, plus, minus);
  const all: [HTMLButtonElement, Sense][] = [[plus, "+"], [minus, "-"]];

  function show(sense: Sense): void {
    for (const [button, own] of all) {
      button.setAttribute("aria-checked", String(own === sense));
      // One stop for the keyboard, arrows within, as radio buttons have it.
      button.tabIndex = own === sense || (sense === "" && own === "+") ? 0 : -1;
    }
  }
  radios(root);
  show("");
  return { root, show };
}
