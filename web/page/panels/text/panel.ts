import type { Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import { withLine } from "../../refused.ts";
import { language } from "../../words.ts";
import { textEditor } from "./editor.ts";
import { hasLongLine, inLines } from "./lines.ts";
import { say } from "./words.ts";

/** The scene's text. */
export const text: Panel = {
  id: "text",
  title: () => say("panel_title"),
  mount(root, app) {
    const box = element("div", { class: "text-editor" });
    const message = element("p", {});
    const go = element("button", { type: "button", class: "small", hidden: true });
    const help = element("p", { class: "help" });
    const layOut = button(() => say("lay_out"), () => app.history.change({ text: inLines(app.history.now.value.text) }), { class: "framed" });
    const long = element("div", {}, worded(element("p"), () => say("long")), layOut);
    root.append(element("div", { class: "text-panel" }, long, box, element("div", { class: "text-status", role: "status" }, message, go), help));
    const editor = textEditor(box, app);
    app.history.now.on(({ text }) => {
      long.hidden = !hasLongLine(text);
      box.hidden = !long.hidden;
    });
    const tell = (): void => {
      const { refused } = app.solved.value;
      message.textContent = refused === null ? say("good") : withLine(refused);
      message.classList.toggle("bad", refused !== null);
      go.hidden = refused?.from === undefined || refused.from === null;
      go.textContent = say("go");
      help.textContent = say("help");
    };
    go.addEventListener("click", () => {
      const { refused } = app.solved.value;
      if (refused !== null && refused.from !== null) editor.go(refused.from, refused.to ?? refused.from);
    });
    app.solved.on(tell);
    language.on(tell);
    app.shown.on((shown) => void (shown === "text" && editor.view.requestMeasure()));
    app.place.on((place) => {
      if (place === null) return;
      app.show("text");
      // The panel is laid out first: a hidden editor cannot scroll.
      requestAnimationFrame(() => editor.go(place.from, place.to));
      app.place.set(null);
    });
  },
};
