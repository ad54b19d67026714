// What the page knows of a mechanism by itself: names, places, mobility, what is hit.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { linkAt, onLink, pointAt } from "../../web/page/build/hit.ts";
import { hasGround, mobility } from "../../web/page/build/mobility.ts";
import type { Opened } from "../../web/page/engine/types.ts";
import { linesAt, placesAt } from "../../web/page/panels/curves/follow.ts";
import { tracedOf } from "../../web/page/panels/curves/choice.ts";
import { freeLink, freePoint } from "../../web/page/panels/mechanism/free_name.ts";
import { freshPlace } from "../../web/page/panels/mechanism/fresh_place.ts";
import { allPoints, type Draft, lengthKey, pairs, parsed, pointsOf, sizeOf } from "../../web/page/panels/parts/scene.ts";
import { viewport } from "../../web/page/look/viewport.ts";

const template = (name: string): Draft => parsed(readFileSync(`../templates/${name}.json`, "utf8"))!;

test("mobility is that of the textbook", () => {
  // Moving links, and what Grübler's formula leaves: 3 n − 2 p.
  const known: [string, number, number][] = [
    ["four-bar", 3, 1], ["slider-crank", 3, 1], ["slotted-lever", 3, 1], ["five-bar", 4, 2], ["watt-1", 5, 1], ["stephenson-3", 5, 1], ["platform-3rrr", 7, 3],
  ];
  for (const [name, links, free] of known) {
    const counted = mobility(template(name));
    assert.deepEqual([counted.links, counted.free, counted.drives], [links, free, free], name);
    assert.ok(hasGround(template(name)));
  }
  assert.equal(mobility({}).free, 0);
  assert.equal(hasGround({}), false);
});

test("a scene half written is read as far as it goes", () => {
  assert.equal(parsed("[1]"), null);
  assert.equal(parsed("{"), null);
  assert.equal(parsed("null"), null);
  const scene = parsed('\uFEFF{ "ground": ["A", 7], "links": { "1": ["A", "B"], "2": { "shape": { "B": [0, 0], "C": [3, -40] } }, "3": 5, "note": "x" } }')!;
  assert.deepEqual(allPoints(scene), ["A", "B", "C"]);
  assert.deepEqual(pointsOf({ points: ["A", 1, "B"] }), ["A", "B"]);
  assert.equal(sizeOf(scene), 40);
});

test("lengths go by their names in either order", () => {
  assert.equal(lengthKey({ BA: 1 }, "A", "B"), "BA");
  assert.equal(lengthKey({ "A1-B": 1 }, "B", "A1"), "A1-B");
  assert.equal(lengthKey({}, "A", "B"), "AB");
  assert.equal(lengthKey({}, "A1", "B"), "A1-B");
  assert.deepEqual(pairs(["A", "B", "C"]), [["A", "B"], ["B", "C"], ["A", "C"]]);
  assert.equal(pairs(["A", "B", "C", "D"]).length, 3);
});

test("new names are free", () => {
  const scene = template("four-bar");
  const taken = allPoints(scene);
  const name = freePoint(scene);
  assert.ok(!taken.includes(name) && !["S", "O"].includes(name));
  assert.notEqual(freePoint(scene, [name]), name);
  const full: Draft = { links: { "1": { points: [..."abcdefghijklmnpqrtuvwxyz"] } } } as Draft;
  assert.equal(freePoint(full), "A1", "small letters take large ones, too");
  assert.equal(freeLink({ links: { "1": { points: ["A", "S2"] }, "4": { points: ["D_3", "A"] } } } as Draft), "5");
});

test("new points have a place of their own", () => {
  assert.deepEqual(freshPlace(new Map(), []), [0, 0]);
  const places = new Map<string, [number, number]>([["A", [0, 0]], ["B", [100, 0]]]);
  for (const beside of [[], ["A"], ["A", "B"]]) {
    const [x, y] = freshPlace(places, beside);
    for (const [u, v] of places.values()) assert.ok(Math.hypot(x - u, y - v) > 20, `${x} ${y}`);
  }
});

test("what is nearest is hit", () => {
  const scene = { ground: { A: [0, 0] }, links: { "1": { points: ["A", "B"] }, "2": { points: ["B", "C", "D"] }, "3": { points: ["E"] } } } as unknown as Draft;
  const places = new Map<string, [number, number]>([["A", [0, 0]], ["B", [10, 0]], ["C", [20, 0]], ["D", [15, 10]], ["E", [100, 100]]]);
  assert.equal(pointAt(places, [9, 1], 3), "B");
  assert.equal(pointAt(places, [5, 0], 3), null);
  assert.equal(linkAt(scene, places, [5, 1], 2, 4), "1");
  assert.equal(linkAt(scene, places, [15, 4], 2, 4), "2", "inside the triangle");
  assert.equal(linkAt(scene, places, [101, 100], 2, 4), "3", "the block");
  assert.equal(linkAt(scene, places, [50, 50], 2, 4), null);
  assert.deepEqual(onLink(scene, places, "1", [4, 3]), [4, 0]);
  assert.deepEqual(onLink(scene, places, "1", [-4, 3]), [0, 0], "no farther than its end");
});

test("the window onto the sheet holds the place under the hand", () => {
  const view = viewport();
  view.resize(800, 600);
  view.fit([0, 0, 297, 210]);
  for (const about of [[10, 20], [400, 300], [790, 590]] as [number, number][]) {
    const before = view.toSheet(about);
    view.zoom(1.7, about);
    const after = view.toSheet(about);
    assert.ok(Math.hypot(before[0] - after[0], before[1] - after[1]) < 1e-9);
    const [x, y] = view.toPane(after);
    assert.ok(Math.hypot(x - about[0], y - about[1]) < 1e-9);
  }
  assert.equal(view.isZoomed(), true);
  const { x } = view.now.value;
  view.pan(-20, 0);
  assert.ok(view.now.value.x > x);
  view.pan(-1e6, 0);
  assert.ok(view.now.value.x <= 297, "the sheet stays in sight");
  view.refit();
  assert.equal(view.isZoomed(), false);
  const [left, top] = view.toPane([0, 0]);
  const [right, bottom] = view.toPane([297, 210]);
  assert.ok(left >= 0 && top >= 0 && right <= 800 && bottom <= 600, "all of it is seen");
});

test("paths are traced of the points that the curves are about", () => {
  const quantity = (name: string, of: "point" | "link", inside: string) => ({ name, head: "", inside, part: "", of, is_vector: false });
  const opened = { quantities: [quantity("v(C)", "point", "C"), quantity("a(C)", "point", "C"), quantity("omega(2)", "link", "2"), quantity("v(D)", "point", "D")], traceable: ["C", "M"] };
  const names = { curves: ["omega(2)", "v(C)", "a(C)", "v(D)"], hodograph: ["v(D)"], path: ["M", "C"] };
  const traced = (kind: "curves" | "hodograph" | "path"): string[] => tracedOf({ kind, names, beyond: false }, opened as unknown as Opened);
  assert.deepEqual(traced("path"), ["M", "C"]);
  assert.deepEqual(traced("curves"), ["C"], "each once, and none that stands still");
  assert.deepEqual(traced("hodograph"), []);
});

test("what marks the drive in curves stands at its value", () => {
  const axis = { low: 0, high: 360, areas: [[10, 5, 180, 40]] as [number, number, number, number][] };
  assert.equal(linesAt(axis, { value: 90, is_angle: true }), "M55 5v40");
  assert.equal(linesAt(axis, { value: -270, is_angle: true }), "M55 5v40", "whole turns are the same");
  assert.equal(linesAt(axis, { value: -1, is_angle: false }), "");
  const ways: [number, number, number][][] = [[[0, 0, 0], [10, 20, 0], [20, 20, 8]], [[30, 1, 1], [40, 1, 1]]];
  assert.deepEqual(placesAt(ways, { value: 15, is_angle: true }), [[20, 4]]);
  assert.deepEqual(placesAt(ways, { value: 365, is_angle: true }), [[10, 0]]);
  assert.deepEqual(placesAt(ways, { value: 0, is_angle: true }), [[0, 0]]);
  assert.deepEqual(placesAt(ways, { value: 35, is_angle: false }), [[1, 1]]);
  assert.deepEqual(placesAt(ways, { value: 25, is_angle: false }), [], "in a gap there is none");
});
