import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import type { FileRequest } from "../../engine/types.ts";
import { PICTURES } from "../output/formats.ts";
import { pngWidth, WIDTHS } from "../output/png.ts";
import { saveOfScene } from "./files.ts";
import { say } from "./words.ts";

/** Rows of buttons: each thing that can be drawn, in each form. */
export function pictures(app: App): HTMLElement {
  const step = (): number => app.view.value.step ?? 1;
  const ofStep = row(app, () => say("this_step", { number: step() }), () => ({ step: step() }), () => `step-${step()}`);
  app.view.on((view) => (ofStep.hidden = view.step === null));
  return element(
    "section",
    {},
    worded(element("h3"), () => say("pictures")),
    row(app, () => say("figure"), () => "figure", () => ""),
    row(app, () => say("worksheet"), () => "worksheet", () => "worksheet"),
    ofStep,
    width(),
  );
}

/** How wide pictures of pixels are. */
function width(): HTMLElement {
  const choice = element("select", { id: "png-width" }, ...WIDTHS.map((width) => element("option", { value: width }, width)));
  choice.onchange = () => pngWidth.set(WIDTHS.find((width) => width === choice.value) ?? pngWidth.value);
  pngWidth.on((width) => (choice.value = width));
  const label = worded(element("label", { class: "what", for: choice.id }), () => say("png_width"));
  return element("div", { class: "row" }, label, element("div", { class: "tools" }, choice));
}

function row(app: App, title: () => string, of: () => FileRequest["of"], part: () => string): HTMLElement {
  const name = worded(element("span", { class: "what" }), title);
  app.view.on(() => (name.textContent = title()));
  const buttons = PICTURES.map(([format, shown]) => {
    const press = button(() => shown, () => void saveOfScene(app, { format, of: of() }, part()));
    app.view.on(() => press.setAttribute("aria-label", say("as", { what: title(), format: shown })));
    return worded(press, () => say("as", { what: title(), format: shown }), "aria-label");
  });
  return element("div", { class: "row" }, name, element("div", { class: "tools" }, ...buttons));
}
