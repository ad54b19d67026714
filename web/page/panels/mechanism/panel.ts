import type { Panel } from "../../app.ts";
import type { Kind } from "../../engine/types.ts";
import { language } from "../../words.ts";
import { element } from "../../dom/element.ts";
import type { Form } from "../parts/form.ts";
import { at, isDrawn, type Draft } from "../parts/scene.ts";
import { keepForm } from "../parts/sheet.ts";
import { command } from "./commands.ts";
import { gallery } from "./gallery.ts";
import { about, ground } from "./ground.ts";
import { drawnPoints, known } from "./known.ts";
import { noteOf } from "./kinds.ts";
import { links } from "./links.ts";
import { loads } from "./loads.ts";
import { near } from "./near.ts";
import { revealing } from "./revealing.ts";
import { rolling } from "./rolling.ts";
import { sliders } from "./sliders.ts";
import { say } from "./words.ts";

/** The whole scene as a form. */
export const mechanism: Panel = {
  id: "mechanism",
  title: () => say("panel_title"),
  mount(root, app) {
    root.append(gallery(app));
    const form = element("div", {});
    root.append(form);
    let kinds: Kind[] = [];
    const { again } = keepForm(form, app, { describe: (scene) => describe(scene, kinds), asked: (ask) => void command(app, ask) });
    void app.engine.kinds().then((all) => {
      kinds = all;
      again();
    });
    revealing(app, form);
  },
};

function describe(scene: Draft, kinds: Kind[]): Form {
  const note = at(scene, ["note"]);
  const first = about();
  if (typeof note === "string") first.help = noteOf(note, kinds, language.value);
  const groups = isDrawn(scene)
    ? [first, drawnPoints(scene), known(scene), links(scene), sliders(scene), rolling(scene), loads(scene)]
    : [first, ground(scene), links(scene), sliders(scene), rolling(scene), loads(scene), near(scene)];
  return { groups };
}
