// What of the student's road needs no browser: pages of the printer, what a value comes to, when a scene can be asked, what is said of a drawing.
import assert from "node:assert/strict";
import test from "node:test";
import { soFar } from "../../web/page/board/judging.ts";
import { begun, slotsOf, turned } from "../../web/page/board/tools.ts";
import type { BoardJudged, Form, FormRow, JudgedEntry } from "../../web/page/engine/types.ts";
import { pagesFor } from "../../web/page/layout/pages.ts";
import type { Solved } from "../../web/page/app.ts";
import { type FormFile, withFewDigits } from "../../web/page/panels/check/form.ts";
import { comesTo } from "../../web/page/panels/check/judged.ts";
import { signal } from "../../web/page/state/signal.ts";
import { goodText } from "../../web/page/state/solving.ts";

test("each sheet has a page of its own size", () => {
  const style = pagesFor([{ width: 297, height: 210 }, { width: 210, height: 297 }]);
  assert.match(style, /@page sheet-0 \{ size: 297mm 210mm; margin: 0; \}/);
  assert.match(style, /@page sheet-1 \{ size: 210mm 297mm; margin: 0; \}/);
  for (const [child, name] of [[1, 0], [2, 1]]) assert.match(style, new RegExp(`:nth-child\\(${child}\\) \\{ page: sheet-${name};`));
  assert.equal(pagesFor([]), "");
});

test("what a value with a unit comes to is said in what its box asks for", () => {
  const [segment, rate] = [{ name: "vplan(p,b)", unit: "mm/s", panel: "velocity", on_paper: true }, { name: "omega(2)", unit: "rad/s", panel: "scheme", on_paper: false }] as FormRow[];
  const form = { scales: { velocity: 2 } } as unknown as Form;
  const file = (values: FormFile["values"], more: Partial<FormFile> = {}): FormFile => ({ kinegon_measured: 1, in: "mm", values: values!, ...more });
  // 325 mm/s at 2 mm/s for each mm, whatever it was typed in; at the form's own scale, where it has one.
  for (const typed of ["325 mm/s", "0,325 m/s", "16.25 cm", "325/2 mm"]) assert.equal(comesTo(325, segment!, file({ "vplan(p,b)": typed }), form), "= 162.5 mm on paper", typed);
  assert.equal(comesTo(325, segment!, file({ "vplan(p,b)": "325 mm/s" }, { mu_v: 5 }), form), "= 65 mm on paper");
  assert.equal(comesTo(325, segment!, file({ "vplan(p,b)": { value: "0.325", unit: "m/s" } }), form), "= 162.5 mm on paper");
  assert.equal(comesTo(325, segment!, file({ "vplan(p,b)": "162.5" }), form), null, "it stands there as it is asked for");
  assert.equal(comesTo(0.5620, rate!, file({ "omega(2)": "+32.2 °/s" }), form), "= 0.562 rad/s");
});

test("what is handed in has the digits of a ruler and not of a computer", () => {
  const values = { a: "1625.0000000000002", b: "-78.56323596193837", c: "+0.5611659711567026", d: "60", e: "", f: "12,5", g: { value: "1234567.89", unit: "mm/s" }, h: "1e-7" };
  const short = { a: "1625", b: "-78.5632", c: "+0.561166", d: "60", e: "", f: "12,5", g: { value: "1234570", unit: "mm/s" }, h: "1e-7" };
  assert.deepEqual(withFewDigits({ kinegon_measured: 1, values }, 6).values, short);
});

test("nothing is asked of a scene before it is solved, nor of one that is none", async () => {
  const none: Solved = { text: "", opened: null, good: "", refused: null };
  const app = { solved: signal(none) };
  let got = "";
  const asked = goodText(app).then((text) => (got = text));
  await Promise.resolve();
  assert.equal(got, "");
  app.solved.set({ ...none, text: "a", good: "a" });
  await asked;
  assert.equal(got, "a");
  app.solved.set({ ...none, text: "b", good: "b" });
  assert.equal(got, "a", "it is asked once");
  assert.equal(await goodText(app), "b");
  const refused = { message: "m", hint: null } as Solved["refused"];
  await assert.rejects(goodText({ solved: signal({ ...none, refused }) }), refused!);
});

test("only what is right is called right", () => {
  const judged = (verdicts: JudgedEntry["verdict"][], is_complete = false): BoardJudged => ({ entries: verdicts.map((verdict, index) => ({ index, does: "", verdict })), first_wrong: null, is_complete });
  const did = [{ compute: "v(B)" }, { lay_off: "b" }, { line: "r1" }];
  assert.equal(soFar(judged([]), []), "Nothing is drawn yet.");
  assert.equal(soFar(judged(["right", "right", "right"]), did), "Right so far.");
  assert.equal(soFar(judged(["right", "right", "right"], true), did), "All is there, and all is right.");
  assert.equal(soFar(judged(["right", "right", "unused"]), did), "Operation 3 leads to no point of the plan yet. All others are right.");
  assert.equal(soFar(judged(["unused", "right", "unused"], true), did), "Operations 1, 3 lead to no point of the plan yet. All that is asked for is there.");
  // What was taken back has no number and says nothing.
  assert.equal(soFar(judged(["undone", "undone", "unused"]), [{ line: "x" }, { undo: 1 }, { line: "r1" }]), "Operation 1 leads to no point of the plan yet.");
});

test("a tool that is chosen begins at right angles, the same one goes on as it was", () => {
  const how = (tool: "line" | "lay_off", entry: ReturnType<typeof begun>): string => slotsOf(tool, entry).find(({ takes }) => takes === "how")!.get(entry);
  const parallel = turned("line", begun("line"));
  assert.equal(how("line", parallel), "parallel");
  assert.equal(how("line", begun("line", parallel)), "parallel", "after a line the next");
  assert.equal(how("lay_off", begun("lay_off")), "normal");
});
