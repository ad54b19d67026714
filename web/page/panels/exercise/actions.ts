import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Refused } from "../../engine/types.ts";
import { saveFile } from "../../files/save.ts";
import { linkBox } from "../output/link.ts";
import { boardChoice } from "./board_choice.ts";
import { studentLink } from "./link.ts";
import type { Made } from "./making.ts";
import { type Saying, say } from "./words.ts";

type Found = { exercise: NonNullable<Made["exercise"]>; wanted: NonNullable<Made["wanted"]> };

function button(text: string, press: () => void, main = false): HTMLButtonElement {
  const made = element("button", { type: "button", ...(main ? { class: "main" } : {}) }, text);
  made.onclick = press;
  return made;
}

/** A file of the exercise, with its ending. */
function file(app: App, { exercise, wanted }: Found, saying: Saying, ending: string, contents: string | "sheet" | "key", type: string): HTMLButtonElement {
  const own = { sheet: "sheet", key: "key", form: "form", scene: "scene", key_values: "key" }[saying as string] ?? saying;
  const name = `${exercise.name}-${own}.${ending}`;
  return button(`${say(saying)} (${ending.toUpperCase()})`, () => {
    if (contents !== "sheet" && contents !== "key") return saveFile(name, contents, type);
    const { text, name: kind, seed, number, options } = wanted;
    void app.engine.exercise_file(text, kind, seed, number, options, contents).then(
      (bytes) => saveFile(name, bytes, type),
      (why: Refused) => app.tell(why.message),
    );
  });
}

/** What a teacher gives to the students: print, link, files. */
export function forStudents(app: App, found: Found): HTMLElement {
  const { exercise } = found;
  const tick = (saying: Saying, checked: boolean): [HTMLElement, HTMLInputElement] => {
    const input = element("input", { type: "checkbox", checked });
    input.onchange = () => box.isGiven() && void link();
    return [element("label", { class: "tick" }, input, element("span", {}, say(saying))), input];
  };
  const [stepsBox, steps] = tick("allow_steps", false);
  const [moreBox, more] = tick("allow_more", true);
  const board = boardChoice(() => box.isGiven() && void link());
  const box = linkBox(app);
  const link = async (): Promise<void> => box.give(await studentLink(app, exercise, found.wanted, { steps: steps.checked, more: more.checked, board: board.now() }));
  return element(
    "section",
    {},
    element("h3", {}, say("student")),
    element(
      "p",
      { class: "buttons" },
      button(say("print"), () => app.print(exercise.sheets), true),
      button(say("link"), () => void link()),
      file(app, found, "sheet", "pdf", "sheet", "application/pdf"),
      // As the program names them.
      button(`${say("sheet")} (SVG)`, () => exercise.sheets.forEach(({ svg }, index) => saveFile(`${exercise.name}-sheet${index === 0 ? "" : `-${index + 1}`}.svg`, svg, "image/svg+xml"))),
      file(app, found, "form", "json", exercise.form, "application/json"),
      file(app, found, "form", "csv", exercise.form_csv, "text/csv"),
      file(app, found, "scene", "json", exercise.text, "application/json"),
    ),
    element("p", { class: "allowed" }, stepsBox, moreBox, board.root),
    ...box.root,
    element("p", { class: "quiet" }, say("print_hint")),
    element("p", { class: "quiet" }, say("link_hint")),
  );
}

/** What stays with the teacher. */
export function forTeacher(app: App, found: Found, key: HTMLElement): HTMLElement {
  const { exercise } = found;
  return element(
    "section",
    {},
    element("h3", {}, say("teacher")),
    element(
      "p",
      { class: "buttons" },
      button(say("open"), () => {
        // A form of the scene before would not fit.
        app.history.change({ text: exercise.text, form: "", drawing: "" });
        app.tell(say("opened", { name: exercise.name }));
      }),
      button(say("print_key"), () => app.print([exercise.key])),
      file(app, found, "key", "pdf", "key", "application/pdf"),
      file(app, found, "key", "svg", exercise.key.svg, "image/svg+xml"),
      file(app, found, "key_values", "json", exercise.key_values, "application/json"),
    ),
    key,
  );
}
