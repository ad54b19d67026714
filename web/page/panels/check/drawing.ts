import type { App } from "../../app.ts";
import { drawingOf } from "../../board/file.ts";
import { say } from "../../board/words.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import type { Form } from "../../engine/types.ts";
import { language } from "../../words.ts";

/** The way to the drawing board. */
export function drawingBlock(app: App): { root: HTMLElement; show(form: Form): void } {
  const open = button(() => "", () => app.drawing.set(true), { id: "board-begin" });
  const call = (): void => void (open.textContent = say((drawingOf(app.history.now.value.drawing ?? "")?.did.length ?? 0) > 0 ? "go_on" : "begin"));
  app.history.now.on(call);
  language.on(call);
  const intro = worded(element("p", { class: "quiet" }), () => say("intro"));
  // In an exam no line is named.
  app.exam.on((is) => (intro.hidden = is));
  const root = element("div", { class: "photograph" }, element("div", { class: "ways" }, open), intro);
  return {
    root,
    show(form) {
      root.hidden = Object.values(form.points).every((points) => points.length < 2);
    },
  };
}
