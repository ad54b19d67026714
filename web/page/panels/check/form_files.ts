import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Refused } from "../../engine/types.ts";
import { askedFor } from "../../files/open.ts";
import { fileName, saveFile } from "../../files/save.ts";
import { readFile, READABLE } from "../../layout/brought.ts";
import type { Signal } from "../../state/signal.ts";
import { goodText } from "../../state/solving.ts";
import { language } from "../../words.ts";
import { cleared, filledNames, type FormFile, formFile, formText } from "./form.ts";
import { refusal } from "./refusal.ts";
import { type Saying, say } from "./words.ts";

/** What a form is called: after its exercise or scene, and its student. */
export function formName(app: App, { exercise, name }: FormFile): string {
  return fileName(exercise ?? app.solved.value.opened?.title, name ?? "form");
}

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

  const problem = element("p", { class: "problem bad", role: "alert", hidden: true });
  /** Why a file was not taken; it stays until another file is. */
  function refuse(name: string, why: Refused | null): void {
    problem.hidden = why === null;
    problem.replaceChildren(...(why === null ? [] : refusal(why, name)));
  }

  async function chosen(accept: string): Promise<{ name: string; text: string } | null> {
    const file = await askedFor(accept);
    return file === null ? null : readFile(file);
  }

  async function read({ name, text }: { name: string; text: string }): Promise<void> {
    refuse("", null);
    if (/"kinegon_marks"\s*:/.test(text)) return scheme.set({ name, text });
    try {
      const form = await app.engine.read_form(await goodText(app), text);
      app.history.change({ form });
      const file = formFile(form);
      app.tell(say("opened", { name, count: file === null ? 0 : filledNames(file).length }));
    } catch (why) {
      refuse(name, why as Refused);
    }
  }
  app.brought.on((file) => {
    if (file === null) return;
    app.brought.set(null);
    void read(file);
  });

  async function saveTable(): Promise<void> {
    try {
      const table = await app.engine.write_form(await goodText(app), formText(present()));
      saveFile(`${formName(app, present())}.csv`, table, "text/csv");
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
    button("open", () => void chosen(READABLE).then((file) => void (file !== null && read(file)))),
    button("save_json", () => saveFile(`${formName(app, present())}.json`, formText(present()), "application/json")),
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
