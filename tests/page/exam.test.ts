// An exam: when nothing is told, and what is noted once something was.
import assert from "node:assert/strict";
import test from "node:test";
import type { BoardUse } from "../../web/page/state/address.ts";
import { examOf } from "../../web/page/state/exam.ts";
import { history } from "../../web/page/state/history.ts";
import { signal } from "../../web/page/state/signal.ts";

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
