import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import type { Store } from "../state/storage.ts";
import { STUDENTS_PANEL } from "../state/studying.ts";
import notices from "../../../templates/workbench-third-party.txt";
import { say, type Saying } from "./words.ts";

const KEYS: [string, Saying][] = [
  ["← →", "key_steps"],
  ["Home End", "key_ends"],
  ["↑ ↓", "key_drive"],
  ["Space", "key_play"],
  ["1 2 3 A", "key_panels"],
  ["+ − 0", "key_zoom"],
  ["M S B", "key_hand"],
  ["P", "key_full"],
  ["D", "key_dark"],
  ["Ctrl+Z Ctrl+Y", "key_undo"],
  ["← → ↑ ↓", "key_joint"],
  ["Esc", "key_escape"],
];

/** What the letters in a plan stand for, in the notation that is usual; other notations have letters of their own. */
const LETTERS: [string, Saying][] = [
  ["p, π", "letter_poles"],
  ["b, c", "letter_images"],
  ["n", "letter_normal"],
  ["k", "letter_coriolis"],
  ["S₃, s₃", "letter_special"],
  ["μ", "letter_scale"],
];

/** What people come for: a heading, what to do, and the panel where they do it; a student is led to the own panel alone. */
const WAYS: [Saying, Saying, string][] = [
  ["way_new", "way_new_how", "values"],
  ["way_lecture", "way_lecture_how", "mechanism"],
  ["way_student", "way_student_how", "check"],
];

/** What is seen and what to do next, what the letters of a plan stand for, the list of keys, and whether letters are keys at all: people who speak to their computer may not want that. */
export function help(app: App, store: Store, begin: () => void): void {
  const dialog = byId<HTMLDialogElement>("help");
  function build(): void {
    const rows = KEYS.map(([keys, what]) =>
      element("tr", {}, element("th", { scope: "row" }, ...keys.split(" ").flatMap((key) => [element("kbd", {}, key), " "])), element("td", {}, say(what))),
    );
    const box = element("input", { type: "checkbox", id: "letters" });
    box.checked = store.preference("letters") !== "no";
    box.onchange = () => store.prefer("letters", box.checked ? "yes" : "no");
    const close = element("button", { type: "button", id: "help-close", class: "main" }, say("close"));
    close.onclick = () => dialog.close();
    const letters = LETTERS.map(([letter, what]) => element("tr", {}, element("th", { scope: "row" }, element("i", {}, letter)), element("td", {}, say(what))));
    const again = element("button", { type: "button", id: "help-tour" }, say("tour"));
    again.onclick = () => (dialog.close(), begin());
    const ways = WAYS.filter(([, , panel]) => !app.student.value || panel === STUDENTS_PANEL).map(([title, how, panel]) => {
      const go = element("button", { type: "button" }, say("way_go", { panel: byId(`tab-${panel}`).textContent ?? "" }));
      go.onclick = () => (dialog.close(), app.show(panel));
      return element("section", {}, element("h3", {}, say(title)), element("p", {}, say(how)), go);
    });
    dialog.replaceChildren(
      element("h2", { id: "help-title" }, say("help_title")),
      element("div", { class: "ways" }, ...ways),
      element(
        "div",
        { class: "columns" },
        element("section", {}, element("h3", {}, say("letters")), element("table", {}, element("tbody", {}, ...letters))),
        element("section", {}, element("h3", {}, say("keys")), element("table", {}, element("tbody", {}, ...rows))),
      ),
      element("details", { id: "notices" }, element("summary", {}, say("notices")), element("pre", { tabindex: "0", lang: "en" }, notices)),
      element("div", { class: "foot" }, element("label", { class: "tick" }, box, say("keys_letters")), again, close),
    );
  }
  // To return false would keep what is pressed in it from doing anything.
  dialog.onclick = (event) => void (event.target === dialog && dialog.close());
  byId("help-button").onclick = () => {
    byId("more").hidePopover?.();
    build();
    dialog.showModal();
    dialog.scrollTop = 0;
  };
}
