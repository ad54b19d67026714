import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import { orTell } from "../../refused.ts";
import { saved, stem } from "./files.ts";
import { say } from "./words.ts";

/** A film of the drives as they run, where the browser can record one. */
export function film(app: App): HTMLElement {
  const { film } = app;
  const progress = element("output", { class: "quiet" });
  const press = button(() => say("film_turn"), () => void make(), { disabled: true, id: "film" });
  let isMaking = false;
  const show = (): void => {
    const { opened } = app.solved.value;
    press.disabled = isMaking || film === null || opened === null || opened.is_drawn || opened.drives.length === 0;
    progress.textContent = isMaking ? say("filming") : "";
  };
  app.solved.on(show);
  async function make(): Promise<void> {
    if (film === null || isMaking) return;
    isMaking = true;
    show();
    const name = stem(app);
    await orTell(app, async () => {
      const made = await film();
      if (typeof made === "string") return app.tell(say(`film_${made}`));
      saved(app, `${name}.${made.type.slice("video/".length)}`, new Uint8Array(await made.arrayBuffer()), made.type);
    });
    isMaking = false;
    show();
  }
  const about = worded(element("p", { class: "quiet" }), () => say(film === null ? "cannot_film" : "film_about"));
  return element("section", {}, worded(element("h3"), () => say("film")), element("div", { class: "tools" }, press), progress, about);
}
