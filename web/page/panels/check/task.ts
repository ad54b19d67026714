import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Exercise } from "../../engine/types.ts";
import { saveFile } from "../../files/save.ts";
import { isDark } from "../../layout/theme.ts";
import { instead } from "../../picture/instead.ts";
import { forDark } from "../../picture/dark.ts";
import { sheetElement } from "../../picture/sheet.ts";
import { said } from "../../refused.ts";
import type { Task } from "../../state/address.ts";
import { newest } from "../../state/newest.ts";
import { marked } from "../../steps/bar.ts";
import { language } from "../../words.ts";
import { begun, formFile, formText } from "./form.ts";
import { say } from "./words.ts";

/** Narrower than this a sheet with letters to read is larger than the screen. */
const NARROW = "(max-width: 599.9px)";

/** The task of a student whose link names an exercise: its sheet to read and to print, its steps as far as the teacher lets them be read, the next one. */
export function taskPart(app: App): HTMLElement {
  const root = element("section", { class: "task", "aria-labelledby": "task-title", hidden: true });
  const large = instead(app, "check");
  let exercise: Exercise | null = null;
  let why = "";

  const maker = newest(async (task: Task) => {
    try {
      exercise = await made(app, task);
      why = "";
    } catch (refused) {
      exercise = null;
      why = said(refused);
    }
    show();
  });

  function show(): void {
    const task = app.task.value;
    root.hidden = task === null;
    if (task === null) return;
    const sheet = exercise;
    const title = element("h3", { id: "task-title" }, say("task", { name: sheet?.name ?? `${task.name}-${task.seed}-${task.number}` }));
    if (sheet === null) return root.replaceChildren(title, element("p", { class: why === "" ? "quiet" : "bad", role: "status" }, why === "" ? say("task_making") : why));
    const front = sheet.sheets[0]!;
    const picture = sheetElement(isDark.value ? forDark(front.svg) : front.svg, "task-sheet", say("task_sheet"));
    const read = (): void => {
      if (large.isShown.value) return large.hide();
      large.show(front);
      if (window.matchMedia(NARROW).matches) app.tell(say("task_drag"));
    };
    const reading = press(say(large.isShown.value ? "task_small" : "task_large"), read);
    const stamp = element("div", { class: "sheet" }, picture);
    stamp.onclick = read;
    const buttons = [
      press(say("task_print"), () => app.print(sheet.sheets), "main"),
      press("PDF", () => void saved(app, task, sheet.name)),
      reading,
      ...(task.more ? [press(say("task_next"), () => void next(task))] : []),
    ];
    root.replaceChildren(title, ...(app.exam.value ? [] : [element("p", { class: "quiet" }, say("task_intro"))]), ...givenIn(sheet), stamp, element("p", { class: "buttons" }, ...buttons), ...(task.steps ? [stepsOf(app)] : []));
  }

  /** Goes on with the next exercise; undo brings this one back. */
  async function next(task: Task): Promise<void> {
    const further = { ...task, number: task.number + 1 };
    try {
      const found = await made(app, further);
      app.history.change({ text: found.text, form: formText(begun(found.form, true)), drawing: "" });
      app.tell(say("task_is", { name: found.name }));
    } catch (refused) {
      app.tell(said(refused));
    }
  }

  app.task.on((task) => {
    if (task !== null) maker.want(task);
    show();
  });
  app.exam.on(show);
  large.isShown.on(show);
  isDark.on(show);
  language.on(show);
  app.solved.on(show);
  // The form names its exercise: so undo leads back to the sheet before, too.
  app.history.now.on(({ form }) => {
    const number = Number(/-(\d+)$/.exec(formFile(form)?.exercise ?? "")?.[1]);
    const task = app.task.value;
    if (task !== null && number >= 1 && number !== task.number) app.task.set({ ...task, number });
  });
  return root;
}

/** What is given and asked for, to read beside the picture: letters on a sheet are too small for a telephone. */
function givenIn({ given }: Exercise): HTMLElement[] {
  return given.map((sentence) => {
    const line = element("p", { class: "given" });
    line.innerHTML = sentence;
    return line;
  });
}

/** The exercise of a task. */
async function made(app: App, { name, text, seed, number, options }: Task): Promise<Exercise> {
  return app.engine.exercise(await baseOf(app, name, text), name, seed, number, options);
}

/** The scene that is varied. */
async function baseOf(app: App, name: string, text: string): Promise<string> {
  return text !== "" ? text : ((await app.engine.kinds()).find((kind) => kind.name === name)?.text ?? "");
}

async function saved(app: App, { name, text, seed, number, options }: Task, file: string): Promise<void> {
  try {
    const bytes = await app.engine.exercise_file(await baseOf(app, name, text), name, seed, number, options, "sheet");
    saveFile(`${file}-sheet.pdf`, bytes, "application/pdf");
  } catch (refused) {
    app.tell(said(refused));
  }
}

/** The steps in words, without what they give. */
function stepsOf(app: App): HTMLElement {
  const { opened } = app.solved.value;
  const steps = (opened?.steps ?? []).map(({ caption }) => element("li", {}, ...marked(caption)));
  return element("details", {}, element("summary", {}, say("task_steps")), element("ol", {}, ...steps));
}

function press(text: string, act: () => void, of = ""): HTMLButtonElement {
  const made = element("button", { type: "button", class: of === "" ? null : of }, text);
  made.onclick = act;
  return made;
}
