import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import { copied } from "../../files/clipboard.ts";
import { baseOf } from "../../state/address.ts";
import { saved, saveOfScene, stem } from "./files.ts";
import { pageWith } from "./original.ts";
import { say } from "./words.ts";

/** Links beyond this many characters are cut by some mail programs and chats. */
const LONG = 8000;

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
  const address = element("input", { type: "text", readonly: true, hidden: true, onfocus: () => address.select() });
  const warning = element("p", { class: "quiet", role: "status" });
  async function copy(): Promise<void> {
    const link = await app.link({ text: app.history.now.value.text, form: app.history.now.value.form, view: app.view.value });
    const size = link.length;
    address.value = link;
    address.hidden = false;
    address.setAttribute("aria-label", say("link_of", { size }));
    const done = await copied(link);
    if (!done) address.select();
    app.tell(done ? say("link_copied", { size }) : say("link_not_copied"));
    const warnings = [say("link_of", { size }) + "."];
    if (size > LONG) warnings.push(say("link_long", { size }));
    if (baseOf(location.href).startsWith("file:")) warnings.push(say("link_local"));
    warning.textContent = warnings.join(" ");
  }
  return [element("div", { class: "tools" }, button(() => say("copy_link"), () => void copy())), address, warning];
}
