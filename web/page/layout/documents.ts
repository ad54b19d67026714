import type { App } from "../app.ts";
import { byId, element } from "../dom.ts";
import type { Kept, Store } from "../state/storage.ts";
import { language } from "../words.ts";
import { icon } from "./icons.ts";
import { notice } from "./messages.ts";
import { say } from "./words.ts";

/** As large as a scene may be (docs/scenes.md). */
const MOST = 4 << 20;

/** Opens a file of a scene. */
async function openFile(app: App, file: File): Promise<void> {
  if (file.size > MOST) return notice(say("file_too_large", { name: file.name }));
  app.open(await file.text());
  app.tell(say("opened_file", { name: file.name }));
}

/** The menu below the title: open a file, or what was worked on before. */
export function documents(app: App, store: Store): void {
  const menu = byId("documents");
  const chooser = element("input", { type: "file", accept: ".json,application/json", hidden: "" });
  chooser.onchange = () => {
    const file = chooser.files?.[0];
    chooser.value = "";
    if (file !== undefined) void openFile(app, file);
  };
  document.body.append(chooser);

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
    return entry([element("span", {}, kept.title || say("untitled")), element("small", {}, when)], () => app.history.change({ text: kept.text, form: kept.form }));
  }

  function build(): void {
    const open = entry([icon("file"), element("span", {}, say("open_file"))], () => chooser.click());
    open.id = "open-file";
    const others = store.others();
    menu.replaceChildren(open);
    if (others.length === 0) return;
    const forget = entry([element("span", {}, say("forget"))], () => store.forgetOthers());
    forget.classList.add("quiet");
    menu.append(element("h2", {}, say("recent")), ...others.map(recent), forget);
  }
  menu.addEventListener("beforetoggle", (event) => (event as ToggleEvent).newState === "open" && build());

  const title = (): void => {
    const text = app.solved.value.opened?.title || say("untitled");
    byId("title").textContent = text;
    document.title = `${text} – Kinegon`;
  };
  app.solved.on(title);
  language.on(title);
}

/** A file that is dropped on the page, or a scene that is pasted outside of a box of text, is opened. */
export function dropped(app: App): void {
  const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
  document.addEventListener("dragover", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  document.addEventListener("dragleave", (event) => event.relatedTarget === null && document.body.classList.remove("dropping"));
  document.addEventListener("drop", (event) => {
    document.body.classList.remove("dropping");
    const file = event.dataTransfer?.files[0];
    if (file === undefined || event.defaultPrevented) return;
    event.preventDefault();
    void openFile(app, file);
  });
  document.addEventListener("paste", (event) => {
    const target = event.target instanceof HTMLElement ? event.target : null;
    if (event.defaultPrevented || target?.closest("input, textarea, [contenteditable=true]") != null) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!/^\s*\{/.test(text)) return;
    event.preventDefault();
    app.open(text);
  });
}
