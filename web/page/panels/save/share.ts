import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import { linkBox } from "../output/link.ts";
import { saved, saveOfScene, stem } from "./files.ts";
import { pageWith } from "./original.ts";
import { say } from "./words.ts";

/** Tables and results of the scene. */
export function numbers(app: App): HTMLElement {
  const motion = button(() => say("motion"), () => void saveOfScene(app, { format: "csv", of: "figure" }, "motion"));
  const results = button(() => say("results"), () => void saveOfScene(app, { format: "json", of: "figure" }, "result"));
  app.solved.on(({ opened }) => (motion.disabled = opened?.is_drawn ?? true));
  return element("section", {}, worded(element("h3"), () => say("numbers")), element("div", { class: "tools" }, motion, results));
}

/** The scene itself: as a file, as a page, as a link. */
export function share(app: App): HTMLElement {
  const text = (): string => app.history.now.value.text;
  const scene = button(() => say("scene_file"), () => saved(app, `${stem(app)}.json`, text(), "application/json"));
  const page = button(() => say("page_file"), () => {
    const whole = pageWith(text(), app.view.value.step);
    if (whole === null) app.tell(say("page_about"));
    else saved(app, `${stem(app)}.html`, whole, "text/html");
  });
  const about = worded(element("p", { class: "quiet" }), () => say("scene_about"));
  const tools = element("div", { class: "tools" }, scene, page);
  return element("section", {}, worded(element("h3"), () => say("scene")), tools, ...linkOf(app), about);
}

/** The button that copies the link, and the link to copy by hand. */
function linkOf(app: App): HTMLElement[] {
  const box = linkBox(app);
  const copy = async (): Promise<void> => box.give(await app.link({ text: app.history.now.value.text, form: app.history.now.value.form, view: app.view.value }));
  return [element("div", { class: "tools" }, button(() => say("copy_link"), () => void copy())), ...box.root];
}
