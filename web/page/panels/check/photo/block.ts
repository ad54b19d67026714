import type { App } from "../../../app.ts";
import { element } from "../../../dom/element.ts";
import { icon } from "../../../dom/icon.ts";
import { button, worded } from "../../../dom/worded.ts";
import type { Form } from "../../../engine/types.ts";
import type { PhotoView } from "./view.ts";
import { say, type Saying } from "./words.ts";

/** The way to a photograph: by the camera, or a picture that is there. */
export function photoBlock(app: App, view: PhotoView): { root: HTMLElement; show(form: Form): void } {
  const chooser = (id: string, saying: Saying, given: Record<string, string>): HTMLLabelElement => {
    const input = element("input", { type: "file", id, accept: "image/*", ...given });
    input.onchange = () => {
      const file = input.files?.[0];
      // The same picture may be chosen again.
      input.value = "";
      if (file !== undefined) void view.open(file);
    };
    return element("label", { class: "file" }, input, icon(id === "photo-take" ? "camera" : "picture"), worded(element("span"), () => say(saying)));
  };
  const take = chooser("photo-take", "take", { capture: "environment" });
  take.classList.add("take");
  // Who has a camera takes a photograph; who has none has one already.
  const choose = chooser("photo-file", window.matchMedia("(pointer: coarse)").matches ? "choose" : "photograph", {});
  const again = button(() => say("again"), view.show, { id: "photo-again", hidden: true });
  view.isThere.on((is) => (again.hidden = !is || view.isShown.value));
  view.isShown.on((is) => (again.hidden = is || !view.isThere.value));
  const root = element("div", { class: "photograph" }, element("div", { class: "ways" }, take, choose, again), worded(element("p", { class: "quiet" }), () => say("intro")));
  app.photographed.on((file) => {
    if (file === null) return;
    app.photographed.set(null);
    void view.open(file);
  });
  return {
    root,
    show(form) {
      root.hidden = Object.values(form.points).every((points) => points.length < 2);
    },
  };
}
