import { element } from "../../../dom/element.ts";
import { icon } from "../../../dom/icon.ts";
import { button, worded } from "../../../dom/worded.ts";
import { say, type Saying } from "./words.ts";

/** What the buttons round the photograph do. */
export interface Presses {
  close(): void;
  right(): void;
  undo(): void;
  zoom(factor: number): void;
  fit(): void;
}

export interface Frame {
  root: HTMLElement;
  title: HTMLElement;
  right: HTMLButtonElement;
  undo: HTMLButtonElement;
  /** What is to be done next, how, and buttons for it. */
  prompt: HTMLElement;
  how: HTMLElement;
  actions: HTMLElement;
  foot: HTMLElement;
}

/** The photograph's own page: its head with tools, the stage, and its foot, which says what comes next. */
export function frame(stage: HTMLElement, chips: HTMLElement, presses: Presses): Frame {
  const tool = (saying: Saying, pictogram: string, press: () => void): HTMLButtonElement => {
    const made = element("button", { type: "button" }, icon(pictogram));
    made.onclick = press;
    for (const attribute of ["aria-label", "title"]) worded(made, () => say(saying), attribute);
    return made;
  };
  const close = tool("close", "back", presses.close);
  close.id = "photo-close";
  close.append(worded(element("span", { class: "text" }), () => say("back")));
  const title = element("h2");
  const right = button(() => say("right_plan"), presses.right, { id: "photo-right", class: "right-plan", "aria-pressed": "false" });
  const undo = tool("undo", "undo", presses.undo);
  undo.id = "photo-undo";
  const zoomers = element("div", { class: "zoomers" }, tool("smaller", "minus", () => presses.zoom(0.8)), tool("fit", "fit", presses.fit), tool("larger", "plus", () => presses.zoom(1.25)));
  const head = element("div", { class: "head" }, close, title, right, undo, zoomers);
  const prompt = element("p", { class: "prompt" });
  const how = element("p", { class: "how" });
  const actions = element("div", { class: "actions" });
  const next = element("div", { class: "next" }, element("div", { class: "says", role: "status" }, prompt, how), actions);
  const foot = element("div", { class: "foot" }, chips, next);
  const root = worded(element("section", { id: "photo", tabindex: "-1", hidden: true }, head, stage, foot), () => say("title"), "aria-label");
  return { root, title, right, undo, prompt, how, actions, foot };
}
