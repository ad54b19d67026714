// The drawing board's file, and the slots of its tools.
import assert from "node:assert/strict";
import test from "node:test";
import { named, rubbed } from "../../web/page/board/entries.ts";
import { drawingOf, drawingText, standing, type Entry } from "../../web/page/board/file.ts";
import { begun, lacking, slotsOf, TOOLS } from "../../web/page/board/tools.ts";
import type { Board } from "../../web/page/engine/types.ts";
import { documentOf, hashOf, type Shared } from "../../web/page/state/address.ts";
import { history } from "../../web/page/state/history.ts";

const filled = (tool: (typeof TOOLS)[number], values: Record<string, string>, from: Entry = begun(tool)): Entry =>
  Object.entries(values).reduce((entry, [blank, value]) => slotsOf(tool, entry).find((slot) => slot.blank === blank)!.set(entry, value), from);

test("what is undone stands no longer, and an undo beyond the beginning takes all", () => {
  const line = { line: "r1" };
  assert.deepEqual(standing([line, line, { undo: 1 }, line, line, { undo: 2 }, line]), [0, 6]);
  assert.deepEqual(standing([line, { undo: 9 }, line]), [2]);
});

test("a drawing is read as it was written", () => {
  const drawing = { kinegon_drawing: 1 as const, snap: "all", mu_v: 2, did: [{ line: "r1", along: { normal: "2" } }, { undo: 1 }] };
  assert.deepEqual(drawingOf(drawingText(drawing)), drawing);
  assert.deepEqual(drawingOf(drawingText({ kinegon_drawing: 1, did: [] })), { kinegon_drawing: 1, did: [] });
  for (const odd of ["", "{", "null", "[]", '{"kinegon_drawing":1}', '{"kinegon":1,"did":[]}']) assert.equal(drawingOf(odd), null, odd);
});

test("boxes filled one by one are the entry of the format", () => {
  assert.deepEqual(filled("line", { on: "velocity", how: "parallel", reference: "3/2", through: "b", name: "r1" }), { line: "r1", along: { parallel: "3/2" }, on: "velocity", through: "b" });
  assert.deepEqual(filled("line", { on: "velocity", how: "angle", reference: "-30.5", through: "p" }), { line: "", along: { angle: -30.5 }, on: "velocity", through: "p" });
  assert.deepEqual(filled("cross", { second: "r2", first: "r1", name: "c" }), { cross: "c", of: ["r1", "r2"] });
  assert.deepEqual(filled("solve", { solve: "a, b", equations: "a + b = 1\n\n a - b = 2 " }), { solve: ["a", "b"], equations: ["a + b = 1", "a - b = 2"] });
  assert.deepEqual(filled("compute", { name: "x", as: "2", sense: "" }), { compute: "x", as: "2" });
  assert.deepEqual(filled("line", { on: "velocity", how: "turned", turned_to: "B,E", turned_from: "B,C", base: "b,c", through: "b" }), { line: "", along: { turned: ["B,C", "B,E"], base: "b,c" }, on: "velocity", through: "b" });
  // How it lies is kept from one line to the next.
  assert.deepEqual(begun("line", filled("line", { how: "parallel", reference: "2" })), { line: "", along: { parallel: "" } });
});

test("what is missing is asked for in order, and names that the board gives are not", () => {
  let entry = begun("line");
  assert.equal(lacking("line", entry)?.blank, "reference");
  entry = filled("line", { reference: "2" }, entry);
  assert.equal(lacking("line", entry)?.blank, "through");
  assert.equal(lacking("line", filled("line", { through: "b" }, entry)), undefined);
  assert.equal(lacking("line", { ...entry, drawn: [1, 2, 30] }), undefined, "by eye");
  assert.equal(lacking("cross", filled("cross", { first: "r1", second: "r2" }))?.blank, "name");
  for (const tool of TOOLS) assert.notEqual(lacking(tool, begun(tool)), undefined, tool);
});

test("the rubber takes what hangs on a thing, and writes the rest again", () => {
  const did: Entry[] = [{ lay_off: "b" }, { line: "r1" }, { line: "r0" }, { undo: 1 }, { line: "r2" }, { cross: "c" }, { compute: "x" }];
  const needs = [[], [0], [0], [], [], [1, 4], []];
  const thing = (name: string, entry: number, sheet = "velocity"): object => ({ name, sheet, entry });
  const board = { things: [thing("b", 9, "acceleration"), thing("b", 0), thing("r1", 1), thing("r2", 4), thing("c", 5)], did: needs.map((each) => ({ needs: each })) } as unknown as Board;
  assert.deepEqual(rubbed({ rub: "r1", on: "velocity" }, did, board), [{ undo: 4 }, { line: "r2" }, { compute: "x" }]);
  assert.deepEqual(rubbed({ rub: "b", on: "velocity" }, did, board), [{ undo: 5 }, { line: "r2" }, { compute: "x" }]);
  assert.equal(rubbed({ rub: "p", on: "velocity" }, did, board), null);
  assert.deepEqual(filled("rub", { name: "velocity/b" }), { rub: "b", on: "velocity" });
});

test("the board names lines and what is measured, and nothing else", () => {
  const board = { free: { line: "r3", point: "h1", number: "m1" }, numbers: [{ name: "bc" }] } as unknown as Board;
  assert.equal(named("line", { line: "" }, board)["line"], "r3");
  assert.equal(named("line", { line: "k" }, board)["line"], "k");
  assert.equal(named("measure", { measure: "", from: "p", to: "n_bC" }, board)["measure"], "pn_bC");
  assert.equal(named("measure", { measure: "", from: "b", to: "c" }, board)["measure"], "m1", "bc is there already");
  assert.equal(named("cross", { cross: "" }, board)["cross"], "");
});

test("undo of the page leaves the drawing of the same scene as it is, and brings that of another back", () => {
  const all = history({ text: "0", form: "" });
  all.change({ form: "f" });
  all.draw("d");
  all.undo();
  assert.deepEqual(all.now.value, { text: "0", form: "", drawing: "d" });
  all.change({ text: "1", drawing: "" });
  all.draw("e");
  all.undo();
  assert.deepEqual(all.now.value, { text: "0", form: "", drawing: "d" });
  all.redo();
  assert.equal(all.now.value.drawing, "e");
});

test("a link carries a drawing and how the board is used; what is not known is left out", async () => {
  const shared: Shared = { text: "{}", drawing: "d", board: { mode: "exam", snap: "none", at_once: false } };
  assert.deepEqual(await documentOf(await hashOf(shared)), shared);
  const odd = { text: "{}", board: { mode: "cheat", snap: 7 } } as unknown as Shared;
  assert.deepEqual(await documentOf(await hashOf(odd)), { text: "{}" });
});
