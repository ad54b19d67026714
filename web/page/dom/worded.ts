import { language } from "../words.ts";
import { element, type Given } from "./element.ts";

/** Keeps an element's text, or one of its attributes, in the page's language. For elements that stay. */
export function worded<Made extends Element>(made: Made, text: () => string, attribute?: string): Made {
  language.on(() => {
    if (attribute === undefined) made.textContent = text();
    else made.setAttribute(attribute, text());
  });
  return made;
}

/** A button that stays, in the page's language. */
export function button(text: () => string, press: () => void, given: Given = {}): HTMLButtonElement {
  return worded(element("button", { type: "button", ...given, onclick: press }), text);
}

/** A box to tick, with its name beside it. */
export function tick(text: () => string, change: (on: boolean) => void): { label: HTMLLabelElement; box: HTMLInputElement } {
  const box = element("input", { type: "checkbox", onchange: () => change(box.checked) });
  return { label: element("label", { class: "tick" }, box, worded(element("span"), text)), box };
}
