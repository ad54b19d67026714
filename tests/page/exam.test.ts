// An exam: when nothing is told, and what is noted once something was.
import assert from "node:assert/strict";
import test from "node:test";
import type { BoardUse } from "../../web/page/state/address.ts";
import { examOf } from "../../web/page/state/exam.ts";
import { history } from "../../web/page/state/history.ts";
import { signal } from "../../web/page/state/signal.ts";
import { type FormFile, formFile, formText, withHints, withHintsOf } from "../../web/page/panels/check/form.ts";

test("an exam is under way until the drawing of its scene is handed in", () => {
  const use: BoardUse = { mode: "exam", snap: "all", at_once: false };
  const page = { student: signal(true), board: signal<BoardUse | null>(use), history: history({ text: "one", form: "" }) };
  const exam = examOf(page);
  assert.equal(exam.value, true);
  page.board.set({ ...use, handed_in: "one" });
  assert.equal(exam.value, false);
  // The next exercise has not been handed in, and the one before has.
  page.history.change({ text: "two" });
  assert.equal(exam.value, true);
  page.history.undo();
  assert.equal(exam.value, false);
  page.board.set({ ...use, mode: "practice" });
  assert.equal(exam.value, false);
  page.board.set(use);
  page.student.set(false);
  assert.equal(exam.value, false, "a teacher tries it");
});

test("a hint that was opened stays opened", () => {
  const [one, other] = [{ kinegon_measured: 1, exercise: "a-1-1", hints: 2, values: { x: "1" } }, { kinegon_measured: 1, exercise: "a-1-1", values: { x: "" } }] as FormFile[];
  const hints = (text: string): number | undefined => formFile(text)?.hints;
  assert.equal(withHints(other!, 48).hints, 48);
  assert.equal(withHints({ ...other!, hints: 50 }, 48).hints, 50);
  assert.deepEqual(Object.keys(withHints(other!, 48)), ["kinegon_measured", "exercise", "hints", "values"]);
  // Undo brings back what was written, and no hint.
  const page = history({ text: "scene", form: formText(other!) });
  page.change({ form: formText(one!) });
  page.undo();
  assert.deepEqual(formFile(page.now.value.form), { ...other!, hints: 2 });
  page.change({ form: formText(withHints(one!, 48)) });
  page.undo();
  page.undo();
  assert.equal(hints(page.now.value.form), 48);
  page.redo();
  assert.equal(hints(page.now.value.form), 48);
  // Another exercise has its own.
  assert.equal(hints(withHintsOf(formText({ ...other!, exercise: "a-1-2" }), formText(one!))), undefined);
  assert.equal(withHintsOf("", formText(one!)), "");
});
