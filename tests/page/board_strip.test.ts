// What the strip of the drawing board asks for, and what it writes.
import assert from "node:assert/strict";
import test from "node:test";
import { choicesOf, chipsOf } from "../../web/page/board/choices.ts";
import { isTurning, written } from "../../web/page/board/entries.ts";
import type { Board } from "../../web/page/engine/types.ts";

const board = {
  names: [{ kind: "number", name: "omega(2)", label: "<i>ω</i>", is_turning: true }, { kind: "number", name: "v(B)", label: "<i>v</i>", is_turning: false }],
  numbers: [{ name: "L(A,B)", label: "AB", value: "60", unit: "mm", entry: null }],
} as unknown as Board;

test("a rate has a sense, and another number none", () => {
  assert.deepEqual(["omega(2)", "v(B)", "x"].map((name) => isTurning(name, board)), [true, false, false]);
  assert.deepEqual(written({ compute: "omega(2)", as: "1", sense: "cw" }, board), { compute: "omega(2)", as: "1", sense: "cw" });
  // The sign that comes out is meant, or the name was another before.
  assert.deepEqual(written({ compute: "omega(2)", as: "-1", sense: "as_it_comes" }, board), { compute: "omega(2)", as: "-1" });
  assert.deepEqual(written({ compute: "v(B)", as: "1", sense: "cw" }, board), { compute: "v(B)", as: "1" });
  assert.deepEqual(choicesOf("sense", board, "velocity").map(([value]) => value), ["", "ccw", "cw", "as_it_comes"]);
  assert.deepEqual(chipsOf("sense", board, {}, "velocity").map(({ name }) => name), ["ccw", "cw", "as_it_comes"]);
});

test("equations are offered their unknowns before the numbers that are there", () => {
  assert.deepEqual(chipsOf("formulas", board, { solve: ["omega(2)", "x"] }, "velocity").map(({ name }) => name), ["omega(2)", "L(A,B)"]);
  assert.deepEqual(chipsOf("formula", board, {}, "velocity").map(({ name }) => name), ["L(A,B)"]);
});
