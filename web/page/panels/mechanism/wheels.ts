import { stepFor } from "../../number.ts";
import { named } from "../output/subject.ts";
import type { Adder, Card, Field, Option, Row } from "../parts/form.ts";
import { at, isDrawn, linksOf, listOf, sizeOf, unitsOf, type Draft, type Path } from "../parts/scene.ts";
import { TOUCHES, touchOf, type Touch } from "./joint_commands.ts";
import { say } from "./words.ts";

/** Pairs of wheels, a wheel and its rack, wheels with a belt: a card each. */
export function wheels(scene: Draft): Card[] {
  return listOf(scene, "gears").map((pair, index) => card(scene, pair, index));
}

export function wheelAdder(): Adder {
  const lists = [
    { label: say("wheel"), options: linksAsOptions },
    { label: say("runs_on"), options: others },
  ];
  return { kind: "adder", path: ["gears", "+"], label: say("add_gear"), text: say("add_gear"), ask: { do: "gear", with: [] }, lists };
}

type Listed = { value: string; text: string };

function linksAsOptions(scene: Draft): Listed[] {
  return linksOf(scene).map((link) => ({ value: link, text: named({ kind: "link", name: link }) }));
}

function bodies(scene: Draft): Listed[] {
  return [{ value: "ground", text: say("ground_word") }, ...linksAsOptions(scene)];
}

/** What a wheel runs on: a new wheel, a new rack, what is there. */
function others(scene: Draft): Listed[] {
  return [{ value: "+wheel", text: say("new_wheel") }, { value: "+rack", text: say("new_rack") }, ...bodies(scene)];
}

function nameOf(body: unknown): string {
  return body === "ground" ? say("ground_word") : String(body ?? "?");
}

function card(scene: Draft, pair: unknown, index: number): Card {
  const path: Path = ["gears", index];
  const touch = touchOf(pair);
  const [first, second] = [0, 1].map((which) => nameOf(at(pair, ["mesh", which]))) as [string, string];
  const title = say("pair_of", { first, second });
  return {
    path,
    title,
    role: say("carried_by", { name: nameOf(at(pair, ["on"])) }),
    line: () => [{ fields: numbers(scene, pair, path, touch) }],
    rows: () => [{ fields: [touching(path, touch)] }, { fields: names(path) }, ...further(scene, path, touch)],
    buttons: [{ text: say("drop_load", { name: title }), icon: "remove", ask: { do: "drop_of", with: ["gears", String(index)] } }],
  };
}

/** The numbers of teeth; of a rack there are none, and its wheel has a radius. */
function numbers(scene: Draft, pair: unknown, path: Path, touch: Touch): Field[] {
  const teeth = [0, 1].filter((which) => at(pair, ["teeth", which]) !== "rack");
  const fields = teeth.map((which): Field => {
    const symbol = which === 0 ? "z₁" : "z₂";
    return { kind: "number", path: [...path, "teeth", which], label: say("teeth_of", { name: nameOf(at(pair, ["mesh", which])) }), symbol, unit: "", step: 1, needed: true };
  });
  return touch === "rack_first" || touch === "rack_second" ? [...fields, radius(scene, path, true)] : fields;
}

function radius(scene: Draft, path: Path, isNeeded: boolean): Field {
  const given = isNeeded ? { needed: true } : { usual: "–" };
  return { kind: "number", path: [...path, "radius"], label: say("pitch_radius"), symbol: "r", unit: unitsOf(scene).length, step: stepFor(sizeOf(scene)), least: 0, ...given };
}

/** How the two touch. */
function touching(path: Path, touch: Touch): Field {
  const options = TOUCHES.map((value): Option => ({ value, text: say(`touch_${value}`), ask: { do: "touch", with: [String(path[1]), value] } }));
  return { kind: "choice", path: [...path, "belt"], label: say("touch"), options, now: TOUCHES.indexOf(touch) };
}

/** The two wheels and what carries them. */
function names(path: Path): Field[] {
  const choice = (own: Path, label: string): Field => ({ kind: "choice", path: [...path, ...own], label, options: bodies });
  return [choice(["mesh", 0], say("first_wheel")), choice(["mesh", 1], say("second_wheel")), choice(["on"], say("carrier"))];
}

/** How they stand to each other, the radius with which a belt's wheels are drawn, the pressure angle. */
function further(scene: Draft, path: Path, touch: Touch): Row[] {
  const isRack = touch === "rack_first" || touch === "rack_second";
  const isBelt = touch === "open" || touch === "crossed";
  const fields: Field[] = [];
  if (isBelt) fields.push(radius(scene, path, false));
  if (!isDrawn(scene) && isRack) fields.push({ kind: "number", path: [...path, "position"], label: say("rack_at_zero"), unit: unitsOf(scene).length, step: stepFor(sizeOf(scene)), usual: "0" });
  if (!isDrawn(scene) && !isRack) fields.push({ kind: "number", path: [...path, "phase"], label: say("second_at_zero"), unit: "°", step: 1, usual: "0" });
  if (!isBelt) fields.push({ kind: "number", path: [...path, "pressure"], label: say("pressure"), symbol: "α", unit: "°", step: 1, least: 0, usual: "0" });
  return fields.map((field) => ({ fields: [field] }));
}
