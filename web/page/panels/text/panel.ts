import type { Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { withLine } from "../../refused.ts";
import { language } from "../../words.ts";
import { textEditor } from "./editor.ts";
import { say } from "./words.ts";

/** The scene's text. */
export const text: Panel = {
  id: "text",
  title: { en: "Text", es: "Texto" },
  mount(root, app) {
    const box = element("div", { class: "text-editor" });
    const message = element("p", {});
    const go = element("button", { type: "button", class: "small", hidden: true });
    const help = element("p", { class: "help" });
    root.append(element("div", { class: "text-panel" }, box, element("div", { class: "text-status", role: "status" }, message, go), help));
    const editor = textEditor(box, app);
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
