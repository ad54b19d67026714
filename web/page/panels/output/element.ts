import { language } from "../../words.ts";

type Attribute = string | number | boolean | ((event: Event) => void);

/**
 * A new element with these attributes and contents.
 *
 * An attribute that is `true` is there without a value, one that is `false` is not; `onclick` and its like are called.
 */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, Attribute> = {},
  ...inside: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (value !== false) made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...inside);
  return made;
}

/** Keeps an element's text, or one of its attributes, in the page's language. For elements that stay. */
export function worded<Made extends Element>(made: Made, text: () => string, attribute?: string): Made {
  language.on(() => {
    if (attribute === undefined) made.textContent = text();
    else made.setAttribute(attribute, text());
  });
  return made;
}

/** A button that stays, in the page's language. */
export function button(text: () => string, press: () => void, attributes: Record<string, Attribute> = {}): HTMLButtonElement {
  return worded(element("button", { type: "button", ...attributes, onclick: press }), text);
}

/** A box to tick, with its name beside it. */
export function tick(text: () => string, change: (on: boolean) => void): { label: HTMLLabelElement; box: HTMLInputElement } {
  const box = element("input", { type: "checkbox", onchange: () => change(box.checked) });
  return { label: element("label", { class: "tick" }, box, worded(element("span"), text)), box };
}
