// What Build works out by itself: where keys lead, what is only begun, what copies are.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { copied, pasted } from "../../web/page/build/copied.ts";
import { crossed } from "../../web/page/build/cross.ts";
import { isBegun, unfinished } from "../../web/page/build/mobility.ts";
import { sight } from "../../web/page/build/sight.ts";
import { drawn, nextChoice, pressed, type Choices, type Present, type Press } from "../../web/page/build/tools.ts";
import type { Drafted, Edit, Refused } from "../../web/page/engine/types.ts";
import { parsed, type Draft } from "../../web/page/panels/parts/scene.ts";

const fourBar = parsed(readFileSync("../templates/four-bar.json", "utf8"))!;
const drafted = { sliders: [] } as unknown as Drafted;
const present: Present = { scene: fourBar, drafted, places: new Map([["A", [0, 0]], ["B", [30, 52]], ["C", [157, 110]], ["D", [160, 0]]]) };
const choices: Choices = { sliding: "block", guided: "along" };
const press = (at: [number, number], point: string | null = null, link: string | null = null): Press => ({ at, under: at, point, link });

test("an arrow goes along its own axis, onto the grid of its step", () => {
  assert.deepEqual(crossed([172.5, 34], "ArrowRight", 10, []), [180, 34]);
  assert.deepEqual(crossed([172.5, 34], "ArrowDown", 2, []), [172.5, 32]);
  assert.equal(crossed([0, 0], "Enter", 10, []), null);
  const things: [number, number][] = [[1, 1], [2, 2], [3, 3]];
  assert.deepEqual(crossed([0, 0], "PageDown", 10, things), [1, 1]);
  assert.deepEqual(crossed([3, 3], "PageDown", 10, things), [1, 1]);
  assert.deepEqual(crossed([1, 1], "PageUp", 10, things), [3, 3]);
  assert.deepEqual(nextChoice(choices, "guided"), { sliding: "block", guided: "across" });
  assert.deepEqual(nextChoice({ ...choices, sliding: "pin" }, "sliding"), choices);
});

test("only what lacks something as a whole is begun", () => {
  const refused = (path: string): Refused => ({ path, message: "no", hint: null }) as unknown as Refused;
  const undriven = structuredClone(fourBar) as Draft & { links: Record<string, { drive?: object }> };
  delete undriven.links["1"]!.drive;
  assert.equal(isBegun(undriven, refused("links")), true);
  assert.equal(isBegun(undriven, refused("links.1.lengths.AB")), false, "a wrong length is a mistake");
  assert.equal(isBegun(fourBar, refused("links")), false, "nothing is missing where it cannot be assembled");
  assert.equal(isBegun({ links: {} }, refused("links")), true);
  assert.match(unfinished(undriven, refused("links")), /3·3 − 8 = 1/);
  assert.match(unfinished(fourBar, refused("links")), /: no$/);
});

test("a copy has its original's lengths and drives under new names, elsewhere", () => {
  const all = copied(present, { points: new Set(["A", "B", "C", "D"]), links: new Set() });
  const { edits, chosen } = pasted(fourBar, all, [20, -20]);
  assert.equal(chosen.points.size, 4);
  const set = (link: string): Edit | undefined => edits.find((edit) => "set" in edit && edit.set[1] === link);
  const crank = set("4") as { value: { points: string[]; lengths: object; drive: object } };
  const own = (fourBar["links"] as Record<string, { drive: object }>)["1"]!;
  assert.deepEqual(crank.value.drive, own.drive);
  assert.deepEqual(Object.values(crank.value.lengths), [60]);
  assert.ok(crank.value.points.every((name) => !["A", "B", "C", "D"].includes(name)));
  // One link alone has no fixed point of its own: nothing else is copied with it.
  const one = copied(present, { points: new Set(), links: new Set(["2"]) });
  assert.deepEqual([one.fixed, one.links.length], [[], 1]);
});

test("tools say what they need, or what follows", () => {
  assert.equal(pressed("drive", present, press([90, 80], null, "2")), "needs_pivot");
  assert.deepEqual(pressed("drive", present, press([15, 26], null, "1")), [{ remove: ["links", "1", "drive"] }]);
  assert.equal(drawn("link", present, press([0, 0]), press([0, 0]), choices), "needs_way");
  assert.equal(drawn("third", present, press([500, 0]), press([0, 9]), choices), "needs_link");
  assert.equal(drawn("link", present, press([30, 52], "B"), press([157, 110], "C"), choices), "joined_already");
  // A link from joint to joint takes the points that are there.
  const edits = drawn("link", present, press([30, 52], "B"), press([160, 0], "D"), choices);
  assert.deepEqual(edits, [{ add_link: { points: [{ name: "B", at: [30, 52] }, { name: "D", at: [160, 0] }] } }]);
});

test("what is fitted fills the stage, small or large", () => {
  for (const [width, height] of [[800, 600], [320, 220]] as const) {
    const own = sight();
    own.resize(width, height);
    own.fit([[0, 0], [300, 100]], "mm");
    const [left, right] = [own.toPane([0, 0])[0], own.toPane([300, 0])[0]];
    assert.ok(left > 0 && right < width && right - left > 0.7 * width, `${left} to ${right} of ${width}`);
    assert.deepEqual(own.rounded([9.9, -0.1], true).map((value) => value / own.grid().fine).map((steps) => steps - Math.round(steps)).map(Math.abs), [0, 0]);
  }
});
