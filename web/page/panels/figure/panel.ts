import type { App, Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { edit } from "../parts/edits.ts";
import type { Form, Group } from "../parts/form.ts";
import { keepForm } from "../parts/sheet.ts";
import { contents, look, page, shown } from "./look.ts";
import { centers, labels, paths } from "./marks.ts";
import { scales, type Scales } from "./scales.ts";
import type { Draft } from "../parts/scene.ts";
import { say } from "./words.ts";

/** What the figure shows, and how: the keys of the scene's `figure`. */
export const figure: Panel = {
  id: "figure",
  title: () => say("panel_title"),
  mount(root, app) {
    const present = presentScales(app);
    const form = element("div", {});
    root.append(form);
    const ofMotion = (scene: Draft): Group[] => {
      const traceable = app.solved.value.opened?.traceable ?? [];
      return [paths(scene, traceable), centers(scene, traceable)];
    };
    const describe = (scene: Draft): Form => ({
      groups: [look(scene), shown(), scales(scene, present.value), page(scene), contents(), ...ofMotion(scene), labels(scene)],
    });
    const { again } = keepForm(form, app, { describe, asked: ({ with: [name] }) => void edit(app, [{ set: ["figure", "labels", name ?? ""], value: name }]) });
    present.on(again);
  },
};

/** The scales at which the scene is drawn at present. */
function presentScales(app: App): Signal<Scales> {
  const present = signal<Scales>({});
  app.solved.on(({ text, opened, refused }) => {
    if (opened === null || refused !== null) return;
    app.engine.form(text, "").then(
      ({ scales }) => present.set(scales),
      () => present.set({}),
    );
  });
  return present;
}
