// Numbers as people type and read them.
import assert from "node:assert/strict";
import test from "node:test";
import { evaluated, shownNumber, stepFor, stepped } from "../../web/page/number.ts";
import { signed, sensed } from "../../web/page/panels/check/sense.ts";
import { isFormula, taken } from "../../web/page/panels/check/units.ts";
import { converted, measured } from "../../web/page/units.ts";
import { csv, fewDigits, shortened } from "../../web/page/panels/values/text.ts";

test("what is typed is worked out", () => {
  const known: [string, number | null][] = [
    ["60", 60], ["2,5", 2.5], [".5", 0.5], ["1/3", 1 / 3], ["2*pi", 2 * Math.PI], ["2π", 2 * Math.PI], ["(3+4)/2", 3.5], ["−3", -3], ["2·3−1", 5],
    ["1e-3", 0.001], ["1e−3", 0.001], ["7:2", 3.5], ["2(1+1)", 4], ["", null], ["a", null], ["1/0", null], ["1.2.3", null], ["(1", null], ["1)", null], ["--1", 1], ["1e400", null],
  ];
  for (const [typed, value] of known) assert.equal(evaluated(typed), value, typed);
});

test("roots and powers are worked out", () => {
  const known: [string, number | null][] = [
    ["sqrt(2)*100", Math.SQRT2 * 100], ["100 sqrt(2)", Math.SQRT2 * 100], ["√2", Math.SQRT2], ["√(3+1)", 2], ["2^0.5", Math.SQRT2], ["-2^2", -4], ["2^-1", 0.5], ["2^3^2", 512],
    ["3*2^2", 12], ["sqrt", null], ["sqrt(2", null], ["sqrt(-1)", null], ["sqrtx", null],
  ];
  for (const [typed, value] of known) {
    const found = evaluated(typed);
    assert.ok(value === null || found === null ? found === value : Math.abs(found - value) <= 1e-12 * Math.abs(value), `${typed}: ${found}`);
  }
});

test("a number with a unit is in the unit of its box, or the unit is named", () => {
  const known: [string, string, ReturnType<typeof measured>][] = [
    ["15 cm", "mm", 150], ["15cm", "mm", 150], ["0,15 m", "mm", 150], ["150", "mm", 150], ["150 mm", "mm", 150], ["1 ft", "in", 12], ["sqrt(4) cm", "mm", 20], ["325/2 mm", "mm", 162.5],
    ["180°", "rad", Math.PI], ["0.5 rev", "°", 180], ["90 deg", "°", 90], ["60 rpm", "rad/s", 2 * Math.PI], ["60 1/min", "rad/s", 2 * Math.PI], ["60 U/min", "rpm", 60], ["360 °/s", "rpm", 60],
    ["1 m/s²", "mm/s²", 1000], ["1 m/s^2", "mm/s²", 1000], ["1 m/s2", "cm/s²", 100], ["2 kN", "N", 2000], ["1 N·m", "N·mm", 1000], ["1 kg·m²", "kg·mm²", 1e6], ["1 N/mm", "N/m", 1000],
    ["15 c", "mm", { unit: "c" }], ["15 kg", "mm", { unit: "kg" }], ["1 m/s", "mm/s²", { unit: "m/s" }], ["15 mm", "", { unit: "mm" }], ["about 15", "mm", null], ["", "mm", null], ["x", "mm", null],
  ];
  for (const [typed, unit, value] of known) {
    const found = measured(typed, unit);
    if (typeof value !== "number" || typeof found !== "number") assert.deepEqual(found, value, typed);
    else assert.ok(Math.abs(found - value) <= 1e-12 * value, `${typed}: ${found}`);
  }
  assert.equal(converted("constructor", "mm"), null);
});

test("a box of the form has the number of a formula, and the unit that stands behind it", () => {
  assert.deepEqual(taken("325/2"), { digits: "162.5", unit: null });
  assert.deepEqual(taken("325/2 mm"), { digits: "162.5", unit: "mm" });
  assert.deepEqual(taken("16,25 cm"), { digits: "16,25", unit: "cm" });
  assert.deepEqual(taken("5.36 1/min"), { digits: "5.36", unit: "1/min" });
  assert.deepEqual(taken("100/3"), { digits: "33.3333", unit: null });
  assert.deepEqual(taken("+32.2 °/s"), { digits: "+32.2", unit: "°/s" });
  assert.deepEqual(["325/2", "325/2 mm", "162.5", "16.25 cm", "x", "-3"].map(isFormula), [true, true, false, false, false, false]);
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
