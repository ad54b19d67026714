import { stepFor } from "../../number.ts";
import type { Adder, Button, Card, Field, Group, Option, Row } from "../parts/form.ts";
import { at, hasLoads, isDrawn, linksOf, listOf, pointsOn, sizeOf, sliderName, unitsOf, type Draft, type Path } from "../parts/scene.ts";
import { named } from "../output/subject.ts";
import { MASS_KEYS } from "./load_commands.ts";
import { placeFields, vectorFields, vectorForm } from "./vector.ts";
import { say } from "./words.ts";

/** Units of mass and of force. */
const UNITS = { mass: ["kg", "g", "t", "lb", "slug", "blob"], force: ["N", "kN", "mN", "kgf", "lbf"] };

/** How far one press of an arrow key goes: values of loads have no common size. */
const STEP = { mass: 0.1, inertia: 100, force: 10, couple: 100, rate: 0.1, coefficient: 0.01 };

/** Masses, forces, couples, springs and friction, a card each; gravity, whether inertia counts, and their units. */
export function loads(scene: Draft): Group {
  const isLoaded = hasLoads(scene);
  const masses = linksOf(scene).filter((link) => hasMass(scene, link)).map((link) => massCard(scene, link));
  return {
    id: "loads",
    title: say("loads"),
    help: say("loads_help"),
    path: ["forces"],
    folded: !isLoaded,
    cards: [
      ...masses,
      ...forceCards(scene),
      ...listOf(scene, "springs").map((spring, index) => springCard(scene, spring, index)),
      ...listOf(scene, "friction").map((friction, index) => frictionCard(scene, friction, index)),
    ],
    rows: [...(linksOf(scene).length === 0 ? [] : [adders(scene)]), ...(isLoaded ? [gravity(scene), analysis(scene), units()] : [])],
  };
}

function hasMass(scene: Draft, link: string): boolean {
  return MASS_KEYS.some((key) => at(scene, ["links", link, key]) !== undefined);
}

type Listed = { value: string; text: string };

function* linksWithoutMass(scene: Draft): Iterable<Listed> {
  for (const link of linksOf(scene)) if (!hasMass(scene, link)) yield { value: link, text: named({ kind: "link", name: link }) };
}

function linkNames(scene: Draft): Listed[] {
  return linksOf(scene).map((link) => ({ value: link, text: named({ kind: "link", name: link }) }));
}

/** The points of links; what follows the last link first, for what people load is mostly there. */
function* spots(scene: Draft): Iterable<Listed> {
  for (const link of linksOf(scene).toReversed()) for (const name of pointsOn(scene, link).toReversed()) yield { value: `${link}:${name}`, text: say("link_at", { link, name }) };
}

function* spotsFromGround(scene: Draft): Iterable<Listed> {
  for (const name of pointsOn(scene, "ground")) yield { value: `ground:${name}`, text: `${say("ground_word")} ${name}` };
  yield* spots(scene);
}

/** The pins and guides without friction, as `pin:B` and `guide:3/ground`. */
function* smoothJoints(scene: Draft): Iterable<Listed> {
  const taken = listOf(scene, "friction").map((friction) => String(at(friction, ["pin"]) ?? at(friction, ["guide"])));
  const bodies = ["ground", ...linksOf(scene)].map((body) => pointsOn(scene, body));
  for (const name of new Set(bodies.flat())) {
    const isPin = bodies.filter((points) => points.includes(name)).length > 1;
    if (isPin && !taken.includes(name)) yield { value: `pin:${name}`, text: say("pin_of", { name }) };
  }
  for (const slider of listOf(scene, "sliders")) {
    const name = sliderName(slider);
    if (!taken.includes(name)) yield { value: `guide:${name}`, text: say("guide_of", { name }) };
  }
}

/** What adds something. */
function adders(scene: Draft): Row {
  const adder = (what: "force" | "couple" | "mass" | "spring" | "friction", path: Path, ...lists: Adder["lists"]): Adder => {
    const text = say(`add_${what}`);
    return { kind: "adder", path, label: text, text, ask: { do: what, with: [] }, lists };
  };
  return {
    fields: [
      adder("force", ["forces", "+"], { label: say("acts_at"), options: spots }),
      adder("couple", ["forces", "+couple"], { label: say("acts_on"), options: linkNames }),
      adder("mass", ["links", "+mass"], { label: say("link"), options: linksWithoutMass }),
      adder("spring", ["springs", "+"], { label: say("from"), options: spots }, { label: say("to"), options: spotsFromGround }),
      // Where nothing presses, nothing rubs.
      ...(hasLoads(scene) ? [adder("friction", ["friction", "+"], { label: say("joint"), options: smoothJoints })] : []),
    ],
  };
}

function gravity(scene: Draft): Row {
  const path: Path = ["gravity"];
  if (at(scene, path) === undefined) return { path, fields: [], buttons: [{ text: say("gravity"), icon: "plus", ask: { do: "gravity", with: [] } }] };
  const { acceleration } = unitsOf(scene);
  const remove: Button = { text: say("drop_gravity"), icon: "remove", edits: [{ remove: path }] };
  return { label: say("gravity"), path, fields: vectorFields(scene, path, acceleration, 10), buttons: [remove] };
}

function analysis(scene: Draft): Row {
  const counts: Option = { value: at(scene, ["analysis"]) === "dynamic" ? "dynamic" : undefined, text: say("with_inertia") };
  return { fields: [{ kind: "choice", path: ["analysis"], label: say("analysis"), options: [counts, { value: "static", text: say("without_inertia") }] }] };
}

function units(): Row {
  const unit = (key: "mass" | "force"): Field => ({ kind: "choice", path: ["units", key], label: say(`${key}_unit`), options: UNITS[key].map((value) => ({ value, text: value })) });
  return { path: ["units"], fields: [unit("mass"), unit("force")] };
}

function massCard(scene: Draft, name: string): Card {
  const link: Path = ["links", name];
  const { mass, forces, length } = unitsOf(scene);
  const amount: Field =
    at(scene, [...link, "weight"]) === undefined
      ? { kind: "number", path: [...link, "mass"], label: say("mass"), symbol: "m", unit: mass, step: STEP.mass, least: 0, needed: true }
      : { kind: "number", path: [...link, "weight"], label: say("weight"), symbol: "G", unit: forces, step: STEP.force, least: 0, needed: true };
  const inertia: Field = { kind: "number", path: [...link, "inertia"], label: say("inertia"), symbol: "J", unit: `${mass}·${length}²`, step: STEP.inertia, least: 0, usual: "0" };
  return {
    path: [...link, "mass"],
    title: say("mass_of", { name }),
    line: () => [{ fields: [amount, inertia] }],
    rows: () => [placeRow(say("center"), placeOn(scene, [...link, "center"], name))],
    buttons: [{ text: say("drop_mass", { name }), icon: "remove", edits: MASS_KEYS.map((key) => ({ remove: [...link, key] })) }],
  };
}

function placeRow(label: string, fields: Field[]): Row {
  return { label, path: fields[0]!.path, fields };
}

/** A place of a link: one of its points, coordinates, or a distance along its axis. */
function placeOn(scene: Draft, path: Path, link: string, isNeeded = true): Field[] {
  const value = at(scene, path);
  const step = stepFor(sizeOf(scene));
  const { length } = unitsOf(scene);
  const ask = (form: string): NonNullable<Option["ask"]> => ({ do: "spot", with: [form, link, ...path.map(String)] });
  const hasAxis = !isDrawn(scene) && link !== "ground" && (pointsOn(scene, link).length > 1 || typeof value === "number");
  const options: Option[] = [
    ...(isNeeded ? [] : [{ text: "–" }]),
    ...pointsOn(scene, link).map((point) => ({ value: point, text: point })),
    ...(hasAxis ? [{ any: "number" as const, text: say("on_axis"), ask: ask("number") }] : []),
    { any: "list", text: say("through_place"), ask: ask("list") },
  ];
  const where: Field = { kind: "choice", path, label: say("at"), options };
  if (typeof value === "number") return [where, { kind: "number", path, label: "x", unit: length, step, needed: true }];
  return [where, ...(Array.isArray(value) ? placeFields(path, length, step) : [])];
}

/** The link on which something acts; a place of the former link gives way to one of the new one. */
function onLink(scene: Draft, path: Path, place: Path, bodies: string[]): Field {
  const options = bodies.map((link): Option => {
    const points = pointsOn(scene, link);
    const stays = typeof at(scene, place) !== "string" || points.includes(String(at(scene, place)));
    const edits = [{ set: path, value: link }, ...(stays || points.length === 0 ? [] : [{ set: place, value: points[0] }])];
    return { value: link, text: link === "ground" ? say("ground_word") : named({ kind: "link", name: link }), edits };
  });
  return { kind: "choice", path, label: say("acts_on"), options };
}

/** The cards of forces and couples, under the names that they have by themselves or are given. */
function forceCards(scene: Draft): Card[] {
  const names = usualNames(scene);
  return listOf(scene, "forces").map((load, index) => forceCard(scene, load, index, names[index]!));
}

/** The names that forces and couples have by themselves: forces F1, F2 …, couples by their links, with a prime for each that has the name already. */
function usualNames(scene: Draft): string[] {
  const loads = listOf(scene, "forces");
  const taken = new Set([...loads, ...listOf(scene, "springs")].map((load) => at(load, ["name"])));
  let forces = 0;
  return loads.map((load) => {
    if (at(load, ["force"]) !== undefined) return `F${++forces}`;
    const on = String(at(load, ["on"]) ?? "").replace(/[(),]/g, "");
    const index = /^[0-9]*$/.test(on) ? on : `_${on}`;
    let primes = "";
    while (taken.has(`M${primes}${index}`)) primes += "'";
    const name = `M${primes}${index}`;
    if (at(load, ["name"]) === undefined) taken.add(name);
    return name;
  });
}

/** The names of forces and couples: those that the scene gives, else their own. */
export function loadNames(scene: Draft): string[] {
  const usual = usualNames(scene);
  return listOf(scene, "forces").map((load, index) => givenName(load, usual[index]!));
}

function nameRow(path: Path, usual: string): Row {
  return { fields: [{ kind: "text", path: [...path, "name"], label: say("load_name"), usual }] };
}

function givenName(load: unknown, usual: string): string {
  return String(at(load, ["name"]) ?? usual);
}

function forceCard(scene: Draft, load: unknown, index: number, usual: string): Card {
  const path: Path = ["forces", index];
  const [force, couple]: [Path, Path] = [[...path, "force"], [...path, "couple"]];
  const { forces, length } = unitsOf(scene);
  const on = String(at(load, ["on"]) ?? "");
  const place = at(load, ["at"]);
  const hasForce = at(scene, force) !== undefined;
  const line: Row[] = hasForce ? [{ label: say("force"), quiet: true, path: force, fields: vectorFields(scene, force, forces, STEP.force) }] : [];
  if (!hasForce || at(scene, couple) !== undefined) {
    line.push({ fields: [{ kind: "number", path: couple, label: say("couple"), symbol: "M", unit: `${forces}·${length}`, step: STEP.couple, needed: !hasForce }] });
  }
  const over = at(load, ["over"]);
  const name = givenName(load, usual);
  return {
    path,
    title: name,
    role: typeof place === "string" ? say("link_at", { link: on, name: place }) : named({ kind: "link", name: on }),
    line: () => line,
    rows: () => [
      nameRow(path, usual),
      { fields: [onLink(scene, [...path, "on"], [...path, "at"], linksOf(scene)), ...placeOn(scene, [...path, "at"], on, hasForce)] },
      ...(hasForce ? [{ fields: [vectorForm(force, say("force")), ...turning(scene, path)] }] : []),
      ...(over === undefined ? [{ fields: [overAdder(index)] }] : changing(path, givenName(load, ""), name)),
    ],
    buttons: [{ text: say("drop_load", { name }), icon: "remove", ask: { do: "drop_of", with: ["forces", String(index)] } }],
  };
}

/** Whether a force turns with its link. */
function turning(scene: Draft, path: Path): Field[] {
  return isDrawn(scene) ? [] : [{ kind: "switch", path: [...path, "turns"], label: say("turns_with_link"), usual: false }];
}

/** What a load may change over: the angles of links, the positions of sliders. */
function* gauges(scene: Draft): Iterable<Listed> {
  for (const link of linksOf(scene)) yield { value: `angle(${link})`, text: say("angle_of", { name: link }) };
  for (const slider of listOf(scene, "sliders")) yield { value: `position(${sliderName(slider)})`, text: say("position_of", { name: sliderName(slider) }) };
}

function overAdder(index: number): Adder {
  const text = say("add_over");
  return { kind: "adder", path: ["forces", index, "+over"], label: text, text, ask: { do: "over", with: [String(index)] }, lists: [{ label: say("changes_over"), options: gauges }] };
}

/** The table by which a load changes; `given` is the name by which a file with several columns may know it. */
function changing(path: Path, given: string, name: string): Row[] {
  const over: Path = [...path, "over"];
  const remove: Button = { text: say("drop_over", { name }), icon: "remove", edits: [{ remove: over }] };
  const of: Field = { kind: "choice", path: [...over, "of"], label: say("changes_over"), options: gauges };
  return [{ path: over, fields: [of], buttons: [remove] }, { fields: [{ kind: "table", path: [...over, "table"], label: say("table_lines"), load: given }] }];
}

function springCard(scene: Draft, spring: unknown, index: number): Card {
  const path: Path = ["springs", index];
  const { forces, length } = unitsOf(scene);
  const usual = `K${index + 1}`;
  const name = givenName(spring, usual);
  const end = (which: number): { on: string; place: unknown } => ({ on: String(at(spring, ["between", which, 0]) ?? ""), place: at(spring, ["between", which, 1]) });
  const told = [0, 1].map(end).map(({ on, place }) => `${on === "ground" ? say("ground_word") : on}${typeof place === "string" ? ` ${place}` : ""}`);
  const bodies = ["ground", ...linksOf(scene)];
  return {
    path,
    title: name,
    role: told.join(" – "),
    line: () => [
      {
        fields: [
          { kind: "number", path: [...path, "rate"], label: say("rate"), symbol: "c", unit: `${forces}/${length}`, step: STEP.rate, least: 0, needed: true },
          { kind: "number", path: [...path, "length"], label: say("free_length"), symbol: "l₀", unit: length, step: stepFor(sizeOf(scene)), least: 0, needed: true },
        ],
      },
    ],
    rows: () => [
      nameRow(path, usual),
      ...[0, 1].map((which): Row => {
        const own: Path = [...path, "between", which];
        return { fields: [onLink(scene, [...own, 0], [...own, 1], bodies), ...placeOn(scene, [...own, 1], end(which).on)] };
      }),
    ],
    buttons: [{ text: say("drop_load", { name }), icon: "remove", ask: { do: "drop_of", with: ["springs", String(index)] } }],
  };
}

function frictionCard(scene: Draft, friction: unknown, index: number): Card {
  const path: Path = ["friction", index];
  const pin = at(friction, ["pin"]);
  const where = pin === undefined ? say("guide_of", { name: String(at(friction, ["guide"]) ?? "") }) : say("pin_of", { name: String(pin) });
  const name = say("friction_of", { name: where });
  const amount: Field =
    at(friction, ["angle"]) === undefined
      ? { kind: "number", path: [...path, "coefficient"], label: say("coefficient"), symbol: "μ", unit: "", step: STEP.coefficient, least: 0, needed: true }
      : { kind: "number", path: [...path, "angle"], label: say("friction_angle"), symbol: "φ", unit: "°", step: 1, least: 0, needed: true };
  const radius: Field = { kind: "number", path: [...path, "radius"], label: say("journal"), symbol: "r", unit: unitsOf(scene).length, step: stepFor(sizeOf(scene)), least: 0, needed: true };
  return {
    path,
    title: name,
    line: () => [{ fields: pin === undefined ? [amount] : [amount, radius] }],
    rows: () => [],
    buttons: [{ text: say("drop_load", { name }), icon: "remove", ask: { do: "drop_of", with: ["friction", String(index)] } }],
  };
}
