import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import { say } from "./words.ts";

/** Holds a point or a length where it is while a joint is pulled in shape. */
export function pinButton(app: App, pin: { point: string } | { length: string }): HTMLElement {
  const [list, name] = "point" in pin ? (["points", pin.point] as const) : (["lengths", pin.length] as const);
  const text = say("point" in pin ? "pin_point" : "pin_length", { name });
  const button = element("button", { type: "button", class: "pin", "aria-label": text, title: text }, icon("pin"));
  button.addEventListener("click", () => {
    const pins = app.pins.value;
    const others = pins[list].filter((other) => other !== name);
    app.pins.set({ ...pins, [list]: others.length < pins[list].length ? others : [...others, name] });
  });
  app.pins.on((pins) => {
    button.setAttribute("aria-pressed", String(pins[list].includes(name)));
  });
  return button;
}
