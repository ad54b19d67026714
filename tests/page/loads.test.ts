// What the form's buttons make of masses, forces and springs, and what its cards say of them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import type { Drafted } from "../../web/page/engine/types.ts";
import { LOAD_COMMANDS } from "../../web/page/panels/mechanism/load_commands.ts";
import { loads } from "../../web/page/panels/mechanism/loads.ts";
import type { Field } from "../../web/page/panels/parts/form.ts";
import { at, hasLoads, parsed, type Draft } from "../../web/page/panels/parts/scene.ts";
import { after } from "./edited.ts";

const PLACES = new Map<string, [number, number]>([["A", [0, 0]], ["B", [30, 40]], ["C", [130, 40]], ["D", [160, 0]]]);

function scene(): Draft {
  return parsed(readFileSync("../templates/four-bar.json", "utf8"))!;
}

function does(from: Draft, name: string, ...given: string[]): Draft {
  return after(from, LOAD_COMMANDS[name]!({ scene: from, places: PLACES, drafted: { sliders: [] } as unknown as Drafted }, ...given));
}

test("the first force brings its unit and its plan, the next neither", () => {
  const one = does(scene(), "force", "3:C");
  assert.equal(at(one, ["units", "force"]), "N");
  assert.equal(at(one, ["units", "mass"]), undefined, "a force needs no unit of mass");
  assert.deepEqual(at(one, ["figure", "panels"]), ["scheme", "velocity", "acceleration", "forces"]);
  assert.deepEqual(one.forces, [{ on: "3", at: "C", force: [0, -100] }]);
  const without = after(one, [{ set: ["figure", "panels"], value: ["scheme"] }]);
  const two = does(without, "couple", "2");
  assert.deepEqual(at(two, ["figure", "panels"]), ["scheme"], "who has put it away does not get it again");
  assert.deepEqual(two.forces?.length, 2);
  assert.ok(hasLoads(two));
});

test("units are those of the lengths", () => {
  const feet = after(scene(), [{ set: ["units", "length"], value: "ft" }]);
  const heavy = does(feet, "mass", "2");
  assert.deepEqual([at(heavy, ["units", "mass"]), at(heavy, ["units", "force"])], ["lb", "lbf"]);
  // 9.80665 m/s² in ft/s², and per min².
  const fall = (from: Draft): number => -(at(does(from, "gravity"), ["gravity", 1]) as number);
  assert.ok(Math.abs(fall(feet) / (9.80665 / 0.3048) - 1) < 1e-3);
  assert.ok(Math.abs(fall(after(feet, [{ set: ["units", "time"], value: "min" }])) / ((9.80665 / 0.3048) * 3600) - 1) < 1e-3);
  assert.ok(Math.abs(fall(scene()) / 9806.65 - 1) < 1e-3);
});

test("a mass has its centre in the middle of its link, also of one that is a list", () => {
  const listed = after(scene(), [{ set: ["links", "2"], value: ["B", "C"] }]);
  assert.deepEqual(at(does(listed, "mass", "2"), ["links", "2"]), { points: ["B", "C"], mass: 1, center: 50 });
  const drawn = { ...scene(), points: {} } as Draft;
  assert.deepEqual(at(does(drawn, "mass", "2"), ["links", "2", "center"]), [80, 40], "in the fixed frame where coordinates are given");
});

test("a spring pulls where it is added", () => {
  const sprung = does(scene(), "spring", "2:C", "ground:A");
  const length = at(sprung, ["springs", 0, "length"]) as number;
  assert.deepEqual(at(sprung, ["springs", 0, "between"]), [["2", "C"], ["ground", "A"]]);
  assert.ok(length > 0 && length < Math.hypot(130, 40));
});

test("what is taken away last takes its list along", () => {
  const two = does(does(scene(), "force", "3:C"), "couple", "2");
  const one = does(two, "drop_of", "forces", "0");
  assert.deepEqual(one.forces, [{ on: "2", couple: 1000 }]);
  assert.equal(does(one, "drop_of", "forces", "0").forces, undefined);
});

test("cards have the names that results have", () => {
  let now = scene();
  for (const [name, ...given] of [["force", "3:C"], ["couple", "2"], ["force", "2:C"], ["spring", "2:C", "ground:A"], ["mass", "2"]]) now = does(now, name!, ...given);
  const group = loads(now);
  assert.equal(group.folded, false);
  assert.equal(loads(scene()).folded, true);
  const cards = group.cards ?? [];
  assert.deepEqual(cards.slice(1).map(({ title }) => title), ["F1", "M2", "F2", "K1"]);
  const fields = (): Field[] => cards.flatMap((card) => [...card.line(), ...card.rows()]).flatMap((row) => row.fields);
  const paths = new Set(fields().map(({ path }) => path.join(".")));
  for (const path of ["links.2.mass", "links.2.inertia", "links.2.center", "forces.0.force.0", "forces.0.turns", "forces.1.couple", "springs.0.rate", "springs.0.between.1.1"]) assert.ok(paths.has(path), path);
});

test("a place of the former link gives way to one of the new link", () => {
  const now = does(scene(), "force", "2:B");
  const row = loads(now).cards![0]!.rows().flatMap(({ fields }) => fields);
  const on = row.find(({ path }) => path.join(".") === "forces.0.on")!;
  assert.ok(on.kind === "choice" && Array.isArray(on.options));
  const moved = (to: string): Draft => after(now, on.options.find(({ value }: { value?: unknown }) => value === to)!.edits!);
  assert.equal(at(moved("1"), ["forces", 0, "at"]), "B", "B is of link 1, too");
  assert.equal(at(moved("3"), ["forces", 0, "at"]), "D");
});
