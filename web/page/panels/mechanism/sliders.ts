import { stepFor } from "../../number.ts";
import type { Adder, Card, Field, Group, Option, Row } from "../parts/form.ts";
import { allPoints, at, groundOf, isDrawn, joined, linksOf, pointsOn, sizeOf, slidersOf, unitsOf, type Path, type Draft } from "../parts/scene.ts";
import { lineOfDrive, restOfDrive } from "./drives.ts";
import { placeFields } from "./vector.ts";
import { named } from "../output/subject.ts";
import { say } from "./words.ts";

/** The sliders, a card each. */
export function sliders(scene: Draft): Group {
  const list = slidersOf(scene);
  const adder: Adder = {
    kind: "adder",
    path: ["sliders", "+"],
    label: say("add_slider"),
    text: say("add_slider"),
    ask: { do: "slider", with: [] },
    lists: [{ label: say("what_slides"), options: things }, { label: say("on"), options: carriers }],
  };
  return {
    id: "sliders",
    title: say("sliders"),
    help: say("sliders_help"),
    path: ["sliders"],
    cards: list.map((slider, index) => card(scene, slider, index)),
    ...(movingPoints(scene).length === 0 ? {} : { adder }),
  };
}

function movingPoints(scene: Draft): string[] {
  const fixed = new Set(groundOf(scene));
  return allPoints(scene).filter((name) => !fixed.has(name));
}

/** What can slide: a new block at a point, a link at one of its points, a pin in a slot. */
function* things(scene: Draft): Iterable<{ value: string; text: string }> {
  const moving = new Set(movingPoints(scene));
  for (const name of moving) yield { value: `new:${name}`, text: say("new_block", { name }) };
  for (const link of linksOf(scene)) for (const name of pointsOn(scene, link)) if (moving.has(name)) yield { value: `${link}:${name}`, text: say("link_at", { link, name }) };
  for (const name of moving) yield { value: `:${name}`, text: say("pin_at", { name }) };
}

function carriers(scene: Draft): { value: string; text: string }[] {
  return ["ground", ...linksOf(scene)].map((value) => ({ value, text: value === "ground" ? say("ground_word") : named({ kind: "link", name: value }) }));
}

function card(scene: Draft, slider: unknown, index: number): Card {
  const path: Path = ["sliders", index];
  const link = at(slider, ["link"]);
  const isPin = at(slider, ["pin"]) !== undefined;
  const choice = (key: string, label: string, names: (now: Draft) => string[]): Field => ({ kind: "choice", path: [...path, key], label, options: (now) => names(now).map((value) => ({ value, text: value })) });
  const what = isPin
    ? [choice("pin", say("pin"), allPoints)]
    : [choice("link", say("sliding_link"), linksOf), choice("at", say("at"), (now) => pointsOn(now, String(link)))];
  const on: Field = { kind: "choice", path: [...path, "on"], label: say("on"), options: carriers };
  return {
    path,
    title: say("slides_on", { point: String(at(slider, ["at"]) ?? at(slider, ["pin"]) ?? "?"), on: carrierOf(slider) }),
    ...(isPin ? { role: say("pin_in_slot") } : {}),
    line: () => [...placeOf(scene, slider, path), ...lineOfDrive(scene, [...path, "drive"])],
    rows: () => [{ fields: [...what, on] }, ...guide(scene, path, String(at(slider, ["on"]) ?? "ground")), ...ends(scene, path, index), ...turnedRow(scene, path, isPin), ...driveOf(scene, slider, path, String(index + 1))],
    buttons: [{ text: say("drop_slider", { name: index + 1 }), icon: "remove", ask: { do: "drop_slider", with: [String(index)] } }],
  };
}

/** What carries the guide, as people say it. */
function carrierOf(slider: unknown): string {
  const on = String(at(slider, ["on"]) ?? "ground");
  return on === "ground" ? say("ground_word") : on;
}

/** A place of the guide that is given by its coordinates. */
function placeOf(scene: Draft, slider: unknown, path: Path): Row[] {
  const through = at(slider, ["through"]);
  if (!Array.isArray(through)) return [];
  const isLevel = (at(slider, ["on"]) ?? "ground") === "ground" && (at(slider, ["along"]) ?? 0) === 0;
  return [{ fields: withOffset(placeFields([...path, "through"], unitsOf(scene).length, stepFor(sizeOf(scene))), isLevel) }];
}

/** Place and direction of a guide on this body, or of a flat profile, which always has a direction. */
export function guide(scene: Draft, path: Path, on: string, isFlat = false): Row[] {
  const points = pointsOn(scene, on);
  const through = at(scene, [...path, "through"]);
  const along = at(scene, [...path, "along"]);
  const canPlace = on === "ground" || at(scene, ["links", on, "shape"]) !== undefined;
  const places: Option[] = [
    ...(on !== "ground" || isDrawn(scene) || through === undefined ? [{ text: say("through_usual") }] : []),
    ...points.map((value) => ({ value, text: value })),
    ...(canPlace || Array.isArray(through) ? [{ any: "list" as const, text: say("through_place"), ask: { do: "place", with: path.map(String) } }] : []),
  ];
  const where: Field[] = [{ kind: "choice", path: [...path, "through"], label: say(isFlat ? "face_through" : "through"), options: places }];
  const direction: Field[] = [{ kind: "choice", path: [...path, "along"], label: say(isFlat ? "face_along" : "along"), options: directions(points, along).slice(isFlat ? 1 : 0) }];
  if (typeof along === "number") direction.push({ kind: "number", path: [...path, "along"], label: say("degrees"), unit: "°", step: 1, needed: true });
  if (Array.isArray(along)) direction.push(...placeFields([...path, "along"], "", 0.1));
  return [{ fields: where }, { fields: direction }];
}

/** Of a level guide on the ground y is what people look for as its offset. */
function withOffset(fields: Field[], isLevel: boolean): Field[] {
  return isLevel ? fields.map((field, index) => (index === 1 ? { ...field, label: say("offset") } : field)) : fields;
}

function directions(points: string[], along: unknown): Option[] {
  const pairs = points.flatMap((a) => points.filter((b) => b !== a).map((b) => joined(a, b)));
  const named = typeof along === "string" && !pairs.includes(along) ? [along, ...pairs] : pairs;
  return [
    { text: say("along_usual") },
    ...named.map((value) => ({ value, text: value })),
    { any: "number", value: 0, text: say("along_degrees") },
    { any: "list", value: [1, 0], text: say("along_direction") },
  ];
}

/** The ends of a slot. */
function ends(scene: Draft, slider: Path, index: number): Row[] {
  if (isDrawn(scene)) return [];
  const path: Path = [...slider, "travel"];
  if (at(scene, path) === undefined) return [{ path, fields: [], buttons: [{ text: say("travel"), icon: "plus", ask: { do: "travel", with: [String(index)] } }] }];
  const fields = (["travel_from", "travel_to"] as const).map((label, end): Field => ({ kind: "number", path: [...path, end], label: say(label), unit: end === 0 ? "" : unitsOf(scene).length, means: unitsOf(scene).length, step: stepFor(sizeOf(scene)), needed: true }));
  return [{ label: say("travel"), path, fields, buttons: [{ text: say("drop_travel", { name: index + 1 }), icon: "remove", edits: [{ remove: path }] }] }];
}

/** The angle of a block whose axis can be seen. */
function turnedRow(scene: Draft, path: Path, isPin: boolean): Row[] {
  const link = String(at(scene, [...path, "link"]));
  const isGiven = at(scene, [...path, "turned"]) !== undefined;
  if (isPin || isDrawn(scene) || (pointsOn(scene, link).length < 2 && !isGiven)) return [];
  return [{ fields: [{ kind: "number", path: [...path, "turned"], label: say("turned"), unit: "°", step: 1, usual: "0" }] }];
}

/** The drive in the slider's own entry; one in the link stands in the link's card. */
function driveOf(scene: Draft, slider: unknown, path: Path, name: string): Row[] {
  const own: Path = [...path, "drive"];
  if (at(slider, ["drive"]) !== undefined) return [restOfDrive(scene, own, name)];
  if (at(scene, ["links", String(at(slider, ["link"])), "drive"]) !== undefined) return [];
  return [{ fields: [], buttons: [{ text: say("drive"), icon: "plus", ask: { do: "push", with: path.map(String) } }] }];
}
