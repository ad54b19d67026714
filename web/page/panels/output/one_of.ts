import { element } from "../../dom/element.ts";
import { worded } from "../../dom/worded.ts";
import type { Signal } from "../../state/signal.ts";
import { language } from "../../words.ts";

let count = 0;

/** One of several to choose. */
export interface OneOf {
  root: HTMLElement;
  /** Asks anew for the options' names. */
  rename(): void;
}

/** Radio buttons side by side for the value of a signal; `named` gives an option's name, or null where it is not to be had. */
export function oneOf<Value extends string>(
  chosen: Signal<Value>,
  values: readonly Value[],
  legend: () => string,
  named: (value: Value) => string | null,
): OneOf {
  count += 1;
  const name = `one-of-${count}`;
  const options = values.map((value) => {
    const radio = element("input", { type: "radio", name, onchange: () => chosen.set(value) });
    const text = element("span");
    return { value, radio, text, label: element("label", {}, radio, text) };
  });
  function rename(): void {
    for (const { value, text, label } of options) {
      const title = named(value);
      label.hidden = title === null;
      text.textContent = title ?? "";
    }
  }
  language.on(rename);
  chosen.on((now) => options.forEach(({ value, radio }) => (radio.checked = value === now)));
  const root = worded(element("div", { class: "one-of", role: "radiogroup" }), legend, "aria-label");
  root.append(...options.map(({ label }) => label));
  return { root, rename };
}
