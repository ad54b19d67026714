// Numbers as people type and read them.
import assert from "node:assert/strict";
import test from "node:test";
import { evaluated, shownNumber, stepFor, stepped } from "../../web/page/number.ts";
import { signed, sensed } from "../../web/page/panels/check/sense.ts";
import { taken } from "../../web/page/panels/check/units.ts";
import { csv, fewDigits, shortened } from "../../web/page/panels/values/text.ts";

test("what is typed is worked out", () => {
  const known: [string, number | null][] = [
    ["60", 60], ["2,5", 2.5], [".5", 0.5], ["1/3", 1 / 3], ["2*pi", 2 * Math.PI], ["2π", 2 * Math.PI], ["(3+4)/2", 3.5], ["−3", -3], ["2·3−1", 5],
    ["1e-3", 0.001], ["1e−3", 0.001], ["7:2", 3.5], ["2(1+1)", 4], ["", null], ["a", null], ["1/0", null], ["1.2.3", null], ["(1", null], ["1)", null], ["--1", 1], ["1e400", null],
  ];
  for (const [typed, value] of known) assert.equal(evaluated(typed), value, typed);
  assert.equal(evaluated("60 mm", "mm"), 60);
  assert.equal(evaluated("60 mm", "m"), null);
});

test("a press of an arrow key goes to a whole step", () => {
  assert.equal(stepped(0.1 + 0.2, 0.1, 1), 0.4);
  assert.equal(stepped(7, 5, 1), 10);
  assert.equal(stepped(-0.04, 0.01, -1), -0.05);
  for (const size of [1e-9, 0.3, 1, 79, 80, 1e6]) {
    const part = stepFor(size) / size;
    assert.ok(part >= 0.00125 - 1e-12 && part <= 0.0125 + 1e-12, `${size}: ${part}`);
  }
  assert.equal(stepFor(0), 1);
  assert.equal(stepFor(Infinity), 1);
});

test("numbers are shown as the scene writes them", () => {
  assert.equal(shownNumber(2.5, true), "2,5");
  assert.equal(shownNumber(1e21, false), "1e21");
  assert.equal(shortened("12.3456789", 4), "12.35");
  assert.equal(shortened("12", 4), "12", "no digit that is not certain");
  assert.equal(shortened("0.000123456", 3), "0.000123");
  assert.equal(fewDigits("B (188.117809, 119.410274)"), "B (188.12, 119.41)");
  assert.equal(fewDigits("B (188,117809; 119,410274)"), "B (188,12; 119,41)");
  const row = { name: 'v("a",b)', label: "", value: "1", unit: "mm/s", error: null, quantity: { name: "", head: "", inside: "", part: "", of: "others", is_vector: false } } as const;
  assert.equal(csv([row]), 'quantity,value,unit,error\r\n"v(""a"",b)",1,mm/s,\r\n');
});

test("a sense and a sign are the same said in two ways", () => {
  for (const turns of [true, false])
    for (const positive of ["clockwise", "counter-clockwise", undefined] as const)
      for (const sense of ["+", "-", ""] as const) {
        const written = signed("3.5", sense, turns, positive);
        // Where the form names a positive sense, a bare number has that one.
        const expected = sense !== "" || positive === undefined ? sense : turns && positive === "clockwise" ? "-" : "+";
        assert.deepEqual(sensed(written, turns, positive), { size: "3.5", sense: expected }, `${turns} ${positive} ${sense}`);
      }
  assert.equal(signed("3", "+", true, "clockwise"), "-3", "counter-clockwise is negative there");
});

test("a unit typed with a number is taken apart", () => {
  assert.deepEqual(taken("0.06 m/s"), { digits: "0.06", unit: "m/s" });
  assert.deepEqual(taken("12,5rpm"), { digits: "12,5", unit: "rpm" });
  assert.deepEqual(taken("−3 rad/s^2"), { digits: "−3", unit: "rad/s²" });
  assert.deepEqual(taken("1e-3"), { digits: "1e-3", unit: null });
  assert.deepEqual(taken("about 3"), { digits: "about 3", unit: null });
});
