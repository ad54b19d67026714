import type { App } from "../../app.ts";
import { element } from "../../dom.ts";
import type { Refused } from "../../engine/types.ts";
import type { Signal } from "../../state/signal.ts";
import { language } from "../../words.ts";
import { askedFor, formName, saveFile, textOf } from "./files.ts";
import { refusal } from "./refusal.ts";
import { cleared, filledNames, type FormFile, formFile, formText } from "./form.ts";
import { type Saying, say } from "./words.ts";

/** Opening and saving: the form as a file, a marking scheme. */
export function formFiles(app: App, scheme: Signal<{ name: string; text: string } | null>, present: () => FormFile): HTMLElement {
  const button = (saying: Saying & `${"open" | "save" | "clear" | "marks"}${string}`, press: () => void): HTMLButtonElement => {
    const made = element("button", { type: "button" });
    made.onclick = press;
    language.on(() => {
      made.textContent = say(saying);
      made.title = say(`${saying}_long` as Saying);
    });
    return made;
  };

  const problem = element("p", { class: "problem bad", role: "alert", hidden: "" });
  /** Why a file was not taken; it stays until another file is. */
  function refuse(name: string, why: Refused | null): void {
    problem.hidden = why === null;
    problem.replaceChildren(...(why === null ? [] : refusal(why, name)));
  }

  async function chosen(accept: string): Promise<{ name: string; text: string } | null> {
    const file = await askedFor(accept);
    if (file === null) return null;
    const text = await textOf(file);
    if (text === null) app.tell(say("too_large", { name: file.name }));
    refuse("", null);
    return text === null ? null : { name: file.name, text };
  }

  async function open(): Promise<void> {
    const file = await chosen(".json,.csv,.txt,.tsv,application/json,text/csv");
    if (file === null) return;
    try {
      const form = await app.engine.read_form(app.solved.value.good, file.text);
      app.history.change({ form });
      const read = formFile(form);
      app.tell(say("opened", { name: file.name, count: read === null ? 0 : filledNames(read).length }));
    } catch (why) {
      refuse(file.name, why as Refused);
    }
  }

  async function saveTable(): Promise<void> {
    try {
      const table = await app.engine.write_form(app.solved.value.good, formText(present()));
      saveFile(`${formName(app, present().exercise, present().name)}.csv`, table, "text/csv");
    } catch (why) {
      app.tell((why as Refused).message);
    }
  }

  const marks = button("marks_open", () => void chosen(".json,application/json").then((file) => file !== null && scheme.set(file)));
  marks.className = "marking";
  const drop = button("marks_drop", () => scheme.set(null));
  const used = element("span", { class: "quiet" });
  scheme.on((now) => {
    drop.hidden = used.hidden = now === null;
    used.textContent = now === null ? "" : say("marks_of", { name: now.name });
  });
  return element(
    "div",
    { class: "files" },
    button("open", () => void open()),
    button("save_json", () => saveFile(`${formName(app, present().exercise, present().name)}.json`, formText(present()), "application/json")),
    button("save_csv", () => void saveTable()),
    button("clear", () => {
      app.history.change({ form: formText(cleared(present())) });
      app.tell(say("cleared"));
    }),
    marks,
    drop,
    used,
    problem,
  );
}
