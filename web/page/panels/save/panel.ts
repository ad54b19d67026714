import type { Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { worded } from "../../dom/worded.ts";
import { construction } from "./construction.ts";
import { film } from "./film.ts";
import { pictures } from "./pictures.ts";
import { print } from "./print.ts";
import { numbers, share } from "./share.ts";
import { say } from "./words.ts";

/** All that can be taken along: files, links, prints. */
export const save: Panel = {
  id: "save",
  title: () => say("panel_title"),
  mount(root, app) {
    const old = worded(element("p", { class: "notice", role: "status", hidden: true }), () => say("old_text"));
    app.solved.on(({ refused }) => (old.hidden = refused === null));
    root.append(old, pictures(app), film(app), print(app), share(app), construction(app), numbers(app));
  },
};
