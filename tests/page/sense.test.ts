// The sense beside a number: what a sign in the box sets, and what goes with it.
import assert from "node:assert/strict";
import test from "node:test";
import { afterTyping, type Chosen, isZero, signed } from "../../web/page/panels/check/sense.ts";

const none: Chosen = { sense: "", isTyped: false, hasSign: false };
/** Letter by letter into an empty box. */
const typed = (from: Chosen, text: string, positive?: "clockwise"): Chosen => [...text].reduce((now, _, at) => afterTyping(now, text.slice(0, at + 1), at === 0, true, positive), from);
/** The box has been left: the buttons have the sign. */
const left = (now: Chosen): Chosen => ({ ...now, hasSign: false });

test("a sign in the box sets the sense, and goes with the number or alone", () => {
  assert.deepEqual(typed(none, "-3.885"), { sense: "-", isTyped: true, hasSign: true });
  assert.equal(typed(none, "−3").sense, "-");
  assert.equal(typed(none, "+3").sense, "+");
  assert.equal(typed(none, "+3", "clockwise").sense, "-");
  assert.equal(typed(none, "3").sense, "");
  // Its sign is taken away.
  assert.equal(afterTyping(typed(none, "-3"), "3", false, true, undefined).sense, "");
  // All is taken away; or all is replaced at once.
  const before = left(typed(none, "-3.885"));
  assert.equal(afterTyping(before, "", true, true, undefined).sense, "");
  assert.equal(afterTyping(before, "3", true, true, undefined).sense, "");
  // A digit is corrected.
  assert.equal(afterTyping(before, "3.88", false, true, undefined).sense, "-");
  assert.equal(afterTyping(before, "+3.88", false, true, undefined).sense, "+");
});

test("a sense that a button has set stays until another is chosen", () => {
  const pressed: Chosen = { sense: "-", isTyped: false, hasSign: false };
  assert.equal(typed(pressed, "3.885").sense, "-");
  assert.equal(afterTyping(pressed, "", true, true, undefined).sense, "-");
  const over = typed(pressed, "+3");
  assert.equal(over.sense, "+");
  assert.equal(afterTyping(over, "", true, true, undefined).sense, "");
});

test("nothing has no sense", () => {
  for (const zero of ["0", "0.0", "0,00", "-0", " + 0 ", ".0"]) assert.ok(isZero(zero), zero);
  for (const other of ["", "-", "0.1", "10", "0 m", "1e0"]) assert.ok(!isZero(other), other);
  assert.equal(signed("0", "-", false, undefined), "0");
  assert.equal(signed("0.5", "-", false, undefined), "-0.5");
});
