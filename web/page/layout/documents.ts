import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { icon } from "../dom/icon.ts";
import { calmed } from "../dom/piles.ts";
import { askedFor } from "../files/open.ts";
import { lesson } from "../state/lesson.ts";
import type { Kept, Store } from "../state/storage.ts";
import { parsed } from "../panels/parts/scene.ts";
import { language } from "../words.ts";
import { openFile, READABLE } from "./brought.ts";
import { say } from "./words.ts";

/** So many letters of a title stand in the toolbar; it cuts them to what fits. */
const LONGEST = 200;

/** The menu below the title: open a file, or what was worked on before. */
export function documents(app: App, store: Store): void {
  const menu = byId("documents");
  function entry(text: Node[], act: () => void): HTMLButtonElement {
    const button = element("button", { type: "button", class: "entry" }, ...text);
    button.onclick = () => {
      menu.hidePopover();
      act();
    };
    return button;
  }

  function recent(kept: Kept): HTMLButtonElement {
    const when = new Date(kept.time).toLocaleString(language.value, { dateStyle: "medium", timeStyle: "short" });
    return entry([element("span", {}, kept.title || say("untitled")), element("small", {}, when)], () => app.history.change({ text: kept.text, form: kept.form, drawing: kept.drawing ?? "" }));
  }

  function build(): void {
    const open = entry([icon("file"), element("span", {}, say("open_file"))], () => void askedFor(READABLE).then((file) => openFile(app, file)));
    open.id = "open-file";
    const others = store.others();
    const taught = lesson();
    menu.replaceChildren(open);
    // In an exam nothing is looked up.
    if (app.exam.value) return;
    if (taught !== null) menu.append(entry([element("span", {}, say("lesson"))], () => app.open(taught.text)));
    if (others.length === 0) return;
    const forget = entry([element("span", {}, say("forget"))], () => store.forgetOthers());
    forget.classList.add("quiet");
    menu.append(element("h2", {}, say("recent")), ...others.map(recent), forget);
  }
  menu.addEventListener("beforetoggle", (event) => (event as ToggleEvent).newState === "open" && build());

  const title = (): void => {
    // In Build another mechanism may stand than the last that was complete.
    const own = app.building.value ? parsed(app.history.now.value.text)?.["title"] : app.solved.value.opened?.title;
    const text = calmed(typeof own === "string" ? own : "").slice(0, LONGEST) || say("untitled");
    byId("title").textContent = text;
    // In full screen the toolbar is away, but the page still has a name.
    document.title = byId("name").textContent = `${text} – Kinegon`;
  };
  app.solved.on(title);
  app.building.on(title);
  language.on(title);
}
