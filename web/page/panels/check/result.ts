import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Cause, Checked, ReportParts } from "../../engine/types.ts";
import { orTell } from "../../refused.ts";
import type { Verdicts } from "./checking.ts";
import type { Overlay } from "./overlay.ts";
import { formFile, formText, MOST_HINTS, withHead } from "./form.ts";
import { refusal } from "./refusal.ts";
import { noteAnswers } from "./told.ts";
import { say } from "./words.ts";

/** An element with a fragment of the engine: text with `<i>`, `<sub>`, `<sup>` alone. */
function fragment<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, html: string, className = ""): HTMLElementTagNameMap[Tag] {
  const made = element(tag, className === "" ? {} : { class: className });
  made.innerHTML = html;
  return made;
}

function folded(summary: string, ...contents: Node[]): HTMLDetailsElement {
  return element("details", {}, element("summary", {}, summary), ...contents);
}

/** What was probably done; what it should be, worked out, is folded, so that somebody may think first. */
function whole(app: App, cause: Cause): Node[] {
  const caption = cause.caption === null ? [] : [fragment("p", cause.caption, "caption")];
  const should = folded(say("should"), ...[cause.should, ...cause.worked].map((text) => fragment("p", text)));
  const behind = [cause.follows, cause.redo].filter((text) => text !== null).map((text) => fragment("p", text));
  const step = cause.step > 0 && !app.student.value ? [element("p", {}, stepButton(app, cause.step))] : [];
  return [fragment("p", cause.done, "done"), ...caption, should, ...behind, ...step];
}

/** How many stages of a cause a student has opened, by what it says. */
const opened = new Map<string, number>();

/** What was probably done, one after the other: to a student by stages, as many as the teacher allows; the form counts them. */
function causes(app: App, parts: ReportParts, again: () => void): HTMLElement {
  const staged = (cause: Cause): Node[] => {
    const stages = [...cause.hints.map((hint) => [fragment("p", hint)]), whole(app, cause)];
    const open = opened.get(cause.done) ?? 0;
    const next = element("button", { type: "button" }, say(open === 0 ? "hint" : "next_hint"));
    next.onclick = () => {
      opened.set(cause.done, open + 1);
      const file = formFile(app.history.now.value.form);
      if (file !== null) app.history.change({ form: formText(withHead(file, "hints", (file.hints ?? 0) + 1)) });
      again();
    };
    const allowed = parts.hints >= MOST_HINTS ? stages.length : Math.min(parts.hints, cause.hints.length);
    return [...stages.slice(0, open).flat(), ...(open < allowed ? [element("p", {}, next)] : [])];
  };
  const items = parts.causes.map((cause) => element("li", {}, ...(app.student.value ? staged(cause) : whole(app, cause))));
  return element("ol", { class: "causes" }, ...items);
}

/** Goes to the step at which a mistake was made. */
function stepButton(app: App, step: number): HTMLButtonElement {
  const button = element("button", { type: "button" }, say("show_step"));
  button.onclick = () => app.view.set({ ...app.view.value, coarse: false, step });
  return button;
}

/** All values beside the right ones. */
function table(parts: ReportParts): HTMLElement {
  const head = element("tr", {}, ...parts.columns.map((name) => fragment("th", name)));
  const rows = parts.rows.map(({ cells }) => element("tr", {}, ...cells.map((cell, index) => fragment(index === 0 ? "th" : "td", cell))));
  return element("div", { class: "table", tabindex: 0, role: "region", "aria-label": say("right_values") }, element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows)));
}

export interface Result {
  root: HTMLElement;
  /** `isFull`: there is something in every box; `isRead`: and it is a value. */
  show(verdicts: Verdicts, isFull: boolean, isRead: boolean): void;
}

/** What the check says as a whole: what probably happened, the student's drawing, the marks. */
export function result(app: App, drawing: Overlay, saveReport: () => void): Result {
  const heading = element("h3", { tabindex: "-1" });
  const root = element("section", { class: "result", "aria-live": "polite" });
  const overlayButton = element("button", { type: "button" });
  overlayButton.onclick = () => (drawing.isShown.value ? drawing.hide() : void drawing.show());
  drawing.isShown.on((is) => {
    overlayButton.textContent = say(is ? "overlay_hide" : "overlay");
    overlayButton.setAttribute("aria-pressed", String(is));
  });
  const rightButton = element("button", { type: "button" });
  rightButton.onclick = () =>
    void orTell(app, async () => {
      await noteAnswers(app, "form");
      app.student.set(false);
      app.tell(say("right_plan_shown"));
    });
  const reportButton = element("button", { type: "button" });
  reportButton.onclick = saveReport;

  /** What tells the right answers: only where these are no secret. */
  function answers(checked: Checked, isRead: boolean): Node[] {
    const parts = checked.parts;
    if (parts === null) return [];
    rightButton.textContent = say("right_plan");
    overlayButton.textContent = say(drawing.isShown.value ? "overlay_hide" : "overlay");
    reportButton.textContent = say("feedback");
    if (app.student.value) return isRead ? [element("p", {}, rightButton), element("p", { class: "quiet" }, say("right_plan_counts"))] : [element("p", { class: "quiet" }, say("right_plan_later"))];
    const isOff = checked.result?.passed !== true;
    const buttons = element("p", { class: "buttons" }, ...(isOff ? [overlayButton] : []), reportButton);
    return [buttons, folded(say("right_values"), table(parts))];
  }

  function told(checked: Checked, isFull: boolean, isRead: boolean, again: () => void): Node[] {
    const { parts } = checked;
    if (parts === null) return [];
    const isOff = checked.result?.values.some((value) => value.verdict === "off") === true || (checked.result?.mirrored ?? []).length > 0;
    const kind = checked.result?.passed === true ? "good" : isOff ? "bad" : "open";
    const missing = isFull || parts.missing === null ? [] : [parts.missing];
    const more = [...missing, ...parts.rests_on, ...(parts.senses === null ? [] : [say("choose_senses")]), ...parts.further];
    return [
      ...(checked.marks === null ? [] : [fragment("p", checked.marks, "marks")]),
      fragment("p", parts.heading, `heading ${kind}`),
      ...(parts.causes.length === 0 ? [] : [causes(app, parts, again)]),
      ...(parts.sure === null || app.student.value ? [] : [fragment("p", parts.sure, "quiet")]),
      ...more.map((text) => fragment("p", text)),
      ...(parts.others.length === 0 || app.student.value ? [] : [folded(parts.others_heading, element("ul", {}, ...parts.others.map((text) => fragment("li", text))))]),
      folded(say("hand"), ...parts.accuracy.map((text) => fragment("p", text))),
      ...answers(checked, isRead),
    ];
  }

  let shown: unknown[] = [];
  const made: Result = {
    root,
    show(verdicts, isFull, isRead) {
      const { checked, refused } = verdicts;
      const again = (): void => ((shown = []), made.show(verdicts, isFull, isRead));
      // What says the same stays as it is: a button that is put in anew while it is pressed hears nothing.
      const what = [checked, refused, isFull, isRead, app.student.value, say("result")];
      if (what.every((part, index) => part === shown[index])) return;
      shown = what;
      heading.textContent = say("result");
      const open = [...root.querySelectorAll("details[open] > summary")].map((summary) => summary.textContent);
      const contents: Node[] =
        refused !== null
          ? [element("p", { class: "problem bad" }, ...refusal(refused))]
          : checked === null
            ? [element("p", { class: "quiet" }, say("nothing_yet"))]
            : told(checked, isFull, isRead, again);
      root.replaceChildren(heading, ...contents);
      // What was unfolded stays so when another value is written.
      for (const summary of root.querySelectorAll("summary")) if (open.includes(summary.textContent)) (summary.parentElement as HTMLDetailsElement).open = true;
    },
  };
  return made;
}
