import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import { orTell } from "../../refused.ts";
import { saved, stem } from "./files.ts";
import { say } from "./words.ts";

/** A film of the drive's turn, where the browser can record one. */
export function film(app: App): HTMLElement {
  const { film } = app;
  const progress = element("output", { class: "quiet" });
  const press = button(() => say("film_turn"), () => void make(), { disabled: true, id: "film" });
  app.solved.on(({ opened }) => (press.disabled = film === null || opened === null || opened.is_drawn || opened.drives.length === 0));
  async function make(): Promise<void> {
    press.disabled = true;
    progress.textContent = say("filming");
    await orTell(app, async () => {
      const made = await film?.();
      if (!made) return app.tell(say("no_film"));
      saved(app, `${stem(app)}.${made.type.slice("video/".length)}`, new Uint8Array(await made.arrayBuffer()), made.type);
    });
    progress.textContent = "";
    press.disabled = false;
  }
  const about = worded(element("p", { class: "quiet" }), () => say(film === null ? "cannot_film" : "film_about"));
  return element("section", {}, worded(element("h3"), () => say("film")), element("div", { class: "tools" }, press), progress, about);
}
