// What the form's buttons make of wheels, profiles that touch and slots, and what its cards say of them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { mobility } from "../../web/page/build/mobility.ts";
import type { Drafted, Edit } from "../../web/page/engine/types.ts";
import { contacts } from "../../web/page/panels/mechanism/contacts.ts";
import { JOINT_COMMANDS, TOUCHES, profileOf, touchOf } from "../../web/page/panels/mechanism/joint_commands.ts";
import { rolling } from "../../web/page/panels/mechanism/rolling.ts";
import { sliders } from "../../web/page/panels/mechanism/sliders.ts";
import { wheels } from "../../web/page/panels/mechanism/wheels.ts";
import type { Card, Field } from "../../web/page/panels/parts/form.ts";
import { at, parsed, type Draft } from "../../web/page/panels/parts/scene.ts";
import { after } from "./edited.ts";

const PLACES = new Map<string, [number, number]>([["A", [0, 0]], ["B", [60, 0]], ["Q", [80, 0]], ["E", [40, 0]], ["K", [20, 0]], ["C", [72, 0]], ["D", [20, 90]]]);

function template(name: string): Draft {
  return parsed(readFileSync(`../templates/${name}.json`, "utf8"))!;
}

function edits(scene: Draft, name: string, ...given: string[]): Edit[] {
  const drafted = { sliders: [{ along: [1, 0], position: 52.3 }] } as unknown as Drafted;
  return JOINT_COMMANDS[name]!({ scene, places: PLACES, drafted }, ...given);
}

function does(scene: Draft, name: string, ...given: string[]): Draft {
  return after(scene, edits(scene, name, ...given));
}

function paths(cards: Card[]): Set<string> {
  const fields = (card: Card): Field[] => [...card.line(), ...card.rows()].flatMap((row) => row.fields);
  return new Set(cards.flatMap(fields).map(({ path }) => path.join(".")));
}

test("a pair is carried by what both wheels have a pin on", () => {
  const train = template("planetary");
  delete (train as { gears?: unknown }).gears;
  const one = does(train, "gear", "3", "2");
  assert.deepEqual(one.gears, [{ mesh: ["3", "2"], teeth: [20, 40], on: "1" }], "sun and planet on the arm");
  const two = does(one, "gear", "2", "ground");
  assert.deepEqual(at(two, ["gears", 1]), { mesh: ["2", "ground"], teeth: [40, 40], on: "1" }, "a wheel keeps its teeth");
  assert.deepEqual(wheels(two).map(({ title, role }) => [title, role]), [["3 with 2", "on 1"], ["2 with ground", "on 1"]]);
  // What slides on the carrier is a rack.
  const rolling = parsed(readFileSync("../tests/page/rolling.json", "utf8"))!;
  assert.deepEqual(does(rolling, "gear", "2", "ground").gears, [{ mesh: ["2", "ground"], teeth: [20, "rack"], on: "1", radius: 20 }]);
});

test("a new wheel stands beside its partner, a new rack below it", () => {
  const train = template("planetary");
  const wheel = edits(train, "gear", "1", "+wheel");
  assert.deepEqual(wheel.map((edit) => Object.keys(edit)[0]), ["add_point", "add_link", "set"]);
  // Beside a wheel of 40 teeth on one of 20, which is 60 mm from it: its rim has 40 mm there, and here.
  const row = { ...template("gear-train"), ground: { A: [0, 0], B: [60, 0] }, links: { 1: ["A"], 2: ["B"] }, gears: [{ mesh: ["1", "2"], teeth: [20, 40], on: "ground" }] } as unknown as Draft;
  const next = edits(row, "gear", "2", "+wheel");
  assert.deepEqual(at(next[0], ["add_point", "at"]), [140, 0]);
  assert.deepEqual(at(next[2], ["value", "teeth"]), [40, 40]);
  const pair = at(wheel[2], ["value"]);
  assert.deepEqual(pair, { mesh: ["1", "4"], teeth: [20, 40], on: "ground" });
  const [link, slider] = edits(train, "gear", "3", "+rack");
  const [x, y] = at(link, ["add_link", "points", 0, "at"]) as [number, number];
  assert.deepEqual([x, y], [0, -20], "below A");
  assert.deepEqual(at(slider, ["add_slider", "on"]), "ground");
});

test("whichever way wheels touch, their numbers can be so, and all comes back", () => {
  let now = template("planetary");
  for (const touch of [...TOUCHES, ...TOUCHES.toReversed()]) {
    now = does(now, "touch", "1", touch);
    const pair = at(now, ["gears", 1]);
    assert.equal(touchOf(pair), touch);
    const numbers = (at(pair, ["teeth"]) as (number | string)[]).filter((teeth): teeth is number => typeof teeth === "number");
    if (touch.startsWith("ring")) assert.ok(numbers[0]! + numbers[1]! < 0, "a ring holds the wheel inside of it");
    const isRack = touch.startsWith("rack");
    assert.equal(at(pair, ["radius"]) !== undefined, isRack || touch === "open" || (touch === "crossed" && at(pair, ["radius"]) !== undefined));
    assert.equal(numbers.length, isRack ? 1 : 2);
    const has = paths(wheels(now));
    assert.equal(has.has("gears.1.position"), isRack);
    assert.equal(has.has("gears.1.phase"), !isRack);
    const isBelt = touch === "open" || touch === "crossed";
    assert.equal(has.has("gears.1.pressure"), !isBelt);
    // What belongs to another way to touch goes with it.
    const keys = { position: isRack, phase: !isRack, pressure: !isBelt };
    for (const [key, isAllowed] of Object.entries(keys)) {
      if (!isAllowed) assert.equal(at(pair, [key]), undefined, `${key} of ${touch}`);
      else now = after(now, [{ set: ["gears", 1, key], value: 4 }]);
    }
  }
});

test("radii of a new contact bring its centres as far apart as they are", () => {
  const cam = template("eccentric-cam");
  delete (cam as { contacts?: unknown }).contacts;
  const next = does(cam, "contact", "1:K", "3:C");
  const [first, second] = at(next, ["contacts", 0, "radii"]) as [number, number];
  assert.equal(first + second, 52);
  assert.equal(profileOf(at(next, ["contacts", 0])), "roller");
  assert.equal(rolling(cam).folded, true);
  assert.equal(rolling(next).folded, false);
});

test("a flat profile has a direction in place of a centre, and loses it again", () => {
  const cam = template("eccentric-cam");
  assert.ok(paths(contacts(cam)).has("contacts.0.centers.1"));
  const flat = does(cam, "profile", "0", "flat");
  const { links, note, ...rest } = at(flat, ["contacts", 0]) as Record<string, unknown>;
  assert.deepEqual(rest, { centers: ["K"], radii: [40], along: 0, through: "C", circular: true });
  const has = paths(contacts(flat));
  assert.ok(has.has("contacts.0.along") && has.has("contacts.0.through") && !has.has("contacts.0.centers.1") && !has.has("contacts.0.name"));
  const round = at(does(flat, "profile", "0", "round"), ["contacts", 0]);
  assert.deepEqual([at(round, ["centers"]), at(round, ["along"]), at(round, ["through"]), at(round, ["roller"])], [["K", "C"], undefined, undefined, undefined]);
});

test("a slot gets ends about where its pin is", () => {
  const crank = template("slider-crank");
  const [low, high] = at(does(crank, "travel", "0"), ["sliders", 0, "travel"]) as [number, number];
  assert.ok(low < 52.3 && 52.3 < high);
  assert.ok(paths(sliders(does(crank, "travel", "0")).cards!).has("sliders.0.travel.1"));
  assert.ok(!paths(sliders(crank).cards!).has("sliders.0.travel.1"));
});

test("wheels and profiles that touch take one motion each", () => {
  assert.deepEqual(mobility(template("planetary")), { links: 3, taken: 8, free: 1, drives: 1 });
  assert.deepEqual(mobility(template("eccentric-cam")), { links: 2, taken: 5, free: 1, drives: 1 });
});
