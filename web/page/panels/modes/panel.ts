import type { App, Panel } from "../../app.ts";
import { chunks } from "../../dom/chunks.ts";
import { element } from "../../dom/element.ts";
import { tick, worded } from "../../dom/worded.ts";
import type { Mode } from "../../engine/types.ts";
import { orTell, said } from "../../refused.ts";
import { language } from "../../words.ts";
import { alone } from "../output/alone.ts";
import { keepCurrent } from "../output/current.ts";
import { sheet, type Sheet } from "../output/sheet.ts";
import { fewDigits } from "../values/text.ts";
import { say } from "./words.ts";

/** Most modes that get a picture of their own. */
const MOST_PICTURES = 24;

/** All ways to assemble the mechanism: a list with pictures, to choose from. */
export const modes: Panel = {
  id: "modes",
  title: () => say("panel_title"),
  mount(root, app) {
    const ghosts = tick(() => say("ghosts"), (on) => app.view.set({ ...app.view.value, modes: on }));
    app.view.on((view) => (ghosts.box.checked = view.modes));
    const about = element("p", { class: "quiet" });
    const message = element("p", { role: "alert", class: "bad" });
    const list = worded(element("div", { role: "radiogroup", class: "modes" }), () => say("list"), "aria-label");
    root.append(about, ghosts.label, message, list);

    keepCurrent(app, modes.id, [app.solved, language], async () => {
      const { good, opened } = app.solved.value;
      if (opened === null) return;
      try {
        const found = await app.engine.modes(good);
        message.textContent = "";
        about.textContent = opened.is_drawn ? say("drawn") : found.length === 1 ? say("single") : say("count", { count: found.length });
        ghosts.label.hidden = found.length < 2;
        await show(list, app, good, found);
      } catch (refused) {
        message.textContent = said(refused);
      }
    });
  },
};

/** Fills the list; the mode that has the focus keeps it. */
async function show(list: HTMLElement, app: App, text: string, found: Mode[]): Promise<void> {
  const hadFocus = list.contains(document.activeElement);
  const pictures = found.slice(0, MOST_PICTURES).map(() => sheet(false, { "aria-hidden": "true" }));
  const choices = chunks(found, "5rem", (mode) => choice(mode, pictures[mode.number - 1], () => void choose(app, text, mode.number)));
  list.replaceChildren(...choices.roots);
  if (hadFocus) list.querySelector<HTMLInputElement>("input:checked")?.focus();
  for (const [index, picture] of pictures.entries()) {
    // What was changed meanwhile is drawn by the next run.
    if (app.solved.value.good !== text || app.shown.value !== modes.id) return;
    await draw(picture, app, text, found[index]!);
  }
}

function choice(mode: Mode, picture: Sheet | undefined, choose: () => void): HTMLLabelElement {
  const radio = element("input", { type: "radio", name: "mode", checked: mode.is_own, onchange: choose });
  const name = element("strong", {}, say("mode", { number: mode.number }));
  const words = element("span", { class: "places" }, fewDigits(mode.shown));
  return element("label", {}, radio, element("span", { class: "mode" }, name, words), ...(picture === undefined ? [] : [picture.root]));
}

/** Draws the scheme of a mode. */
async function draw(picture: Sheet, app: App, text: string, mode: Mode): Promise<void> {
  const other = mode.is_own ? text : await app.engine.choose_mode(text, mode.number);
  const { picture: drawn, box } = await alone(app, other);
  picture.show(drawn.svg, box);
}

function choose(app: App, text: string, number: number): Promise<void> {
  return orTell(app, async () => {
    app.history.change({ text: await app.engine.choose_mode(text, number) });
    app.tell(say("chosen", { number }));
  });
}
