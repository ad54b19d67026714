import type { App, Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Form, Refused } from "../../engine/types.ts";
import { saveFile } from "../../files/save.ts";
import { redo, undo } from "../../layout/keys.ts";
import { language } from "../../words.ts";
import { bar } from "./bar.ts";
import { checking } from "./checking.ts";
import { drawingBlock } from "./drawing.ts";
import { begun, filledNames, type FormFile, formFile, formText, withoutValue, withValue } from "./form.ts";
import { formFiles, formName } from "./form_files.ts";
import { head } from "./head.ts";
import { judged } from "./judged.ts";
import { overlay } from "./overlay.ts";
import { photoBlock } from "./photo/block.ts";
import { photoView } from "./photo/view.ts";
import { pointsPart } from "./points.ts";
import { result } from "./result.ts";
import { rows } from "./rows.ts";
import { taskPart } from "./task.ts";
import { say } from "./words.ts";

function mount(root: HTMLElement, app: App): void {
  root.classList.add("check-panel");
  const check = checking(app);
  const drawing = overlay(app, () => check.scheme.value?.text ?? null);
  let form: Form | null = null;
  /** Counts visits of fields: what is typed in one visit is one entry of undo. */
  let visit = 0;

  /** The form as it is, or one to begin with. */
  const present = (): FormFile => formFile(app.history.now.value.form) ?? begun(form?.json ?? "", false);

  function change(how: (file: FormFile) => FormFile, gesture: string): void {
    app.history.change({ form: formText(how(present())) }, `form:${gesture}:${visit}`);
  }
  const typed = (how: (file: FormFile) => FormFile, field: string): void => {
    check.writing.set(field);
    change(how, field);
  };
  function left(): void {
    visit += 1;
    check.writing.set(null);
  }

  const intro = element("p", { class: "quiet" });
  const exam = element("p", { class: "quiet", hidden: true });
  const top = head(typed, left);
  const boxes = rows({
    changed(name, value, isTyping) {
      if (isTyping) check.writing.set(name);
      else check.unchecked.add(name);
      change((file) => withValue(file, name, value), name);
      if (!isTyping) left();
    },
    left,
    remove: (name) => change((file) => withoutValue(file, name), `remove ${name}`),
  });
  const points = pointsPart(change, left, present);
  const whole = result(app, drawing, () => {
    void drawing.drawn().then(({ feedback }) => saveFile(`${formName(app, present())}.html`, feedback, "text/html"), (why: Refused) => app.tell(why.message));
  });
  const toResult = (): void => {
    whole.root.scrollIntoView({ block: "start" });
    whole.root.querySelector("h3")?.focus({ preventScroll: true });
  };
  const foot = bar({
    result: toResult,
    firstOff: () => boxes.firstOff()?.focus(),
  });
  const files = formFiles(app, check.scheme, present);
  const photo = photoView(app, {
    change,
    left,
    present,
    form: () => form,
    toResult,
  });
  drawing.isShown.on((is) => is && photo.hide());
  const camera = photoBlock(app, photo);
  const drawn = drawingBlock(app);
  const all = element("div", { class: "all" }, taskPart(app), exam, intro, drawn.root, camera.root, files, top.root, boxes.root, points.root, whole.root);
  const none = element("p", { class: "quiet" });
  root.append(none, all, foot.root);
  // The browser's own undo ends at the field's edge; the page's goes through all of the form.
  root.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const act = { z: event.shiftKey ? redo : undo, y: redo }[event.key.toLowerCase()];
    if (act === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    left();
    act(app);
  });

  /** Shows what the form says now. */
  function show(): void {
    if (form === null) return;
    const file = present();
    top.show(file);
    points.show(file);
    boxes.show(file, judged(file, form, check.verdicts.value, check.unchecked));
    const asked = form.rows.filter((row) => row.is_asked);
    const filled = new Set(filledNames(file));
    const given = new Set(check.verdicts.value.checked?.parts?.rows.map((row) => row.name) ?? []);
    const count = asked.filter((row) => filled.has(row.name) || given.has(row.name)).length;
    const isRead = asked.every((row) => given.has(row.name) && !check.unchecked.has(row.name));
    whole.show(check.verdicts.value, count === asked.length, isRead);
    photo.follow();
    foot.show(check.verdicts.value, count, asked.length);
  }

  /** Builds the boxes of another scene, or of a form with other names. */
  function build(): void {
    none.textContent = form === null ? say("no_scene") : form.rows.length === 0 ? say("no_boxes") : "";
    none.hidden = none.textContent === "";
    all.hidden = foot.root.hidden = !none.hidden;
    if (form === null) return;
    intro.textContent = say("intro");
    exam.textContent = say("exam");
    top.build(form);
    boxes.build(form);
    points.build(form);
    camera.show(form);
    drawn.show(form);
    show();
  }

  let known = "";
  let isAsking = false;
  async function refresh(): Promise<void> {
    const { form: text } = app.history.now.value;
    const { good } = app.solved.value;
    const file = formFile(text);
    const key = `${good}\n${Object.keys(file?.values ?? {}).map((name) => name.replace(/\/mu$/, "")).join("\n")}`;
    if (key === known || good === "") return show();
    if (isAsking) return;
    isAsking = true;
    known = key;
    const boxesOf = (of: Form | null): string => JSON.stringify([of?.rows, of?.points]);
    const before = boxesOf(form);
    try {
      form = await app.engine.form(good, file === null ? "" : text);
    } catch {
      // A form of another scene, or none at all: the check says what is wrong with it.
      form = await app.engine.form(good, "").catch(() => null);
    }
    isAsking = false;
    // The same boxes stay, and with them what is being written: the first letter makes a form of none.
    if (form === null || boxesOf(form) !== before) build();
    void refresh();
  }

  app.history.now.on(() => void refresh());
  app.solved.on(() => void refresh());
  check.verdicts.on((verdicts) => {
    show();
    if (!verdicts.isChecking) drawing.follow();
  });
  // A letter is told first and then put into the form: shown in between, the field would lose it.
  check.writing.on(() => queueMicrotask(show));
  app.student.on(show);
  // In an exam there is the exercise, the way to the board, and whose it is.
  app.exam.on((is) => {
    exam.hidden = !is;
    for (const part of [intro, camera.root, files, boxes.root, points.root, whole.root, foot.root]) part.classList.toggle("put-away", is);
    top.root.classList.toggle("name-alone", is);
    if (is) photo.hide();
  });
  language.on(() => form !== null && build());
}

export const checkPanel: Panel = { id: "check", title: () => say("panel_title"), mount };
