/** What the tools do, from where they are pressed to where they are let go: changes of the scene. */
import type { Drafted, Edit } from "../engine/types.ts";
import { freeLink, freePoint } from "../panels/mechanism/free_name.ts";
import { at, groundOf, isDrawn, joined, linksOf, pointsOn, slidersOf, type Draft } from "../panels/parts/scene.ts";
import { onLink, type Places } from "./hit.ts";
import { loaded } from "./loading.ts";
import type { LoadPress } from "./seen_loads.ts";
import { short, type Place } from "./sight.ts";

/** The tools in the order of their buttons and keys. */
export const TOOLS = ["select", "link", "third", "fixed", "slider", "cylinder", "drive", "drop", "load"] as const;
export type Tool = (typeof TOOLS)[number];

/** Tools that go from one place to another; the others are done where they are pressed. */
export const DRAWN: readonly Tool[] = ["link", "third", "slider", "cylinder", "load"];

/** What slides: a new block on a pin, the link itself, a pin in a slot. */
export const SLIDING = ["block", "itself", "pin"] as const;
export type Sliding = (typeof SLIDING)[number];
/** How a guide runs on a link. */
export const GUIDED = ["along", "across"] as const;
export type Guided = (typeof GUIDED)[number];

/** What is chosen besides the tool. */
export interface Choices {
  sliding: Sliding;
  guided: Guided;
}

/** The keys that choose the next of these. */
export const KEY_OF = { sliding: "w", guided: "x" };

/** The choices with the next of one of them. */
export function nextChoice(now: Choices, which: keyof Choices): Choices {
  const next = <Value>(all: readonly Value[], value: Value): Value => all[(all.indexOf(value) + 1) % all.length]!;
  return which === "sliding" ? { ...now, sliding: next(SLIDING, now.sliding) } : { ...now, guided: next(GUIDED, now.guided) };
}

/** What was pressed: a point or a link that is there, and the place. */
export interface Press {
  at: Place;
  /** The place under the pointer itself, on no grid. */
  under: Place;
  point: string | null;
  link: string | null;
  /** What of a load that is there, where no joint is nearer. */
  load?: LoadPress;
}

/** What is there. */
export interface Present {
  scene: Draft;
  places: Places;
  drafted: Drafted;
  /** A step of the grid. */
  grain: number;
}

/** The changes that follow; a word of the page where there are none, because something is not there that is needed, or is there already. */
export type Follows = Edit[] | "needs_point" | "needs_link" | "needs_pivot" | "needs_way" | "joined_already";

/** What follows where a tool goes from one place to another. */
export function drawn(tool: Tool, present: Present, from: Press, to: Press, choices: Choices): Follows {
  const isSame = from.at[0] === to.at[0] && from.at[1] === to.at[1];
  switch (tool) {
    case "link":
      return isSame ? "needs_way" : linked(present, from, to);
    case "third":
      return from.link === null ? "needs_link" : thirdOn(present, from.link, to);
    case "slider":
      return slid(present, from, to, choices);
    case "cylinder":
      return isSame ? "needs_way" : cylinder(present, from, to);
    case "load":
      return loaded(present, from, isSame ? from : to);
    default:
      return [];
  }
}

/** What follows where a tool is pressed. */
export function pressed(tool: Tool, present: Present, what: Press): Follows {
  switch (tool) {
    case "fixed":
      return fixed(present, what);
    case "drive":
      return driven(present, what);
    case "drop":
      return what.point !== null ? [{ drop_point: what.point }] : what.link !== null ? [{ drop_link: what.link }] : [];
    default:
      return [];
  }
}

/** The end of something new: a point that is there, a new one on a link, or a new one. */
function end({ scene, places }: Present, press: Press, also: string[] = []): { name: string; at: Place; before: Edit[] } {
  if (press.point !== null) return { name: press.point, at: places.get(press.point) ?? press.at, before: [] };
  const name = freePoint(scene, also);
  if (press.link === null || pointsOn(scene, press.link).length < 2) return { name, at: press.at, before: [] };
  const place = onLink(scene, places, press.link, press.at).map(short) as Place;
  return { name, at: place, before: [{ add_point: { link: press.link, name, at: place } }] };
}

function linked(present: Present, from: Press, to: Press): Follows {
  const first = end(present, from);
  const second = end(present, to, [first.name]);
  if (first.name === second.name) return "needs_way";
  const isJoined = linksOf(present.scene).some((link) => [first, second].every(({ name }) => pointsOn(present.scene, link).includes(name)));
  if (isJoined) return "joined_already";
  const points = [first, second].map(({ name, at: place }) => ({ name, at: place }));
  return [...first.before, ...second.before, { add_link: { points } }];
}

function thirdOn(present: Present, link: string, to: Press): Follows {
  if (to.point !== null && pointsOn(present.scene, link).includes(to.point)) return "needs_way";
  const name = to.point ?? freePoint(present.scene);
  return [{ add_point: { link, name, at: to.at } }];
}

function fixed(present: Present, what: Press): Follows {
  const { scene } = present;
  const { name, at: place, before } = end(present, what);
  const ground = groundOf(scene);
  const isFixed = ground.includes(name);
  if (isDrawn(scene)) {
    const list: Edit = { set: ["ground"], value: isFixed ? ground.filter((other) => other !== name) : [...ground, name] };
    return what.point === null ? [...before, { add_point: { link: "ground", name, at: place } }] : [list];
  }
  if (!isFixed) return [...before, { remove: ["near", name] }, { add_point: { link: "ground", name, at: place } }];
  const isInUse = linksOf(scene).some((link) => pointsOn(scene, link).includes(name));
  return isInUse ? [{ remove: ["ground", name] }, { set: ["near", name], value: place }] : [{ drop_point: name }];
}

/** The direction from one place to another, in degrees. */
export function degrees([x, y]: Place, [u, v]: Place): number {
  return short(Math.round((Math.atan2(v - y, u - x) * 18_000) / Math.PI) / 100);
}

function slid(present: Present, from: Press, to: Press, { sliding, guided }: Choices): Follows {
  const { scene, places } = present;
  const { name, at: place } = end(present, { ...from, link: null });
  const isNew = from.point === null;
  if (isNew && sliding !== "block") return "needs_point";
  const carrier = to.link !== null && !pointsOn(scene, to.link).includes(name) ? to.link : "ground";
  if (carrier === "ground" && from.at[0] === to.at[0] && from.at[1] === to.at[1]) return "needs_way";
  const sliders = slidersOf(scene);
  const number = sliders.length;
  const edits: Edit[] = [];
  let link = "";
  if (sliding === "block") {
    link = freeLink(scene);
    edits.push({ add_link: { points: [{ name, at: place }] } });
  } else if (sliding === "itself") {
    const having = linksOf(scene).filter((other) => other !== carrier && pointsOn(scene, other).includes(name));
    const itself = having.find((other) => pointsOn(scene, other).length === 1) ?? having[0];
    if (itself === undefined) return "needs_link";
    link = itself;
  }
  const points = pointsOn(scene, carrier);
  const own = axisOf(present, carrier);
  const straight = guided === "along" && points.length > 1 ? joined(points[0]!, points[1]!) : guided === "along" ? 0 : 90;
  const along = carrier === "ground" ? degrees(from.at, to.at) : straight;
  edits.push({ add_slider: { link, at: name, on: carrier, along } });
  if (carrier !== "ground" && guided === "across" && points.length > 1) {
    const away = (point: string): number => Math.hypot(...([0, 1].map((axis) => (places.get(point)?.[axis] ?? Infinity) - to.at[axis]!) as Place));
    const nearest = points.reduce((best, next) => (away(next) < away(best) ? next : best));
    edits.push({ set: ["sliders", number, "through"], value: nearest });
  }
  const guide = carrier === "ground" ? Number(along) : own + (guided === "along" ? 0 : 90);
  const turned = sliding === "itself" && !isDrawn(scene) ? within(axisOf(present, link) - guide) : 0;
  if (turned !== 0) edits.push({ set: ["sliders", number, "turned"], value: turned });
  return edits;
}

/** An angle between −180° and 180°, to a hundredth. */
function within(angle: number): number {
  const rounded = Math.round(angle * 100) / 100;
  return short(rounded - 360 * Math.round(rounded / 360));
}

/** The direction of a link's axis, in degrees: between its first points, or along the guide of a block. */
function axisOf({ scene, places, drafted }: Present, link: string): number {
  const [from, to] = pointsOn(scene, link).map((name) => places.get(name));
  if (from !== undefined && to !== undefined) return degrees(from, to);
  const sliders = slidersOf(scene);
  const index = sliders.findIndex((slider) => at(slider, ["link"]) === link);
  const along = drafted.sliders[index]?.along;
  return along == null ? 0 : degrees([0, 0], along as Place) + Number(at(sliders[index], ["turned"]) ?? 0);
}

/** Cylinder and rod of a length that its drive changes: each is so long, in parts of what it is now. */
const PART = 0.65;

function cylinder(present: Present, from: Press, to: Press): Follows {
  const { scene } = present;
  const first = end(present, from);
  const second = end(present, to, [first.name]);
  if (first.name === second.name) return "needs_way";
  const head = freePoint(scene, [first.name, second.name]);
  const piston = freePoint(scene, [first.name, second.name, head]);
  const barrel = freeLink(scene);
  const rod = freeLink(scene, [barrel]);
  const between = (part: number): Place => [0, 1].map((axis) => short(first.at[axis]! + part * (second.at[axis]! - first.at[axis]!))) as Place;
  const whole = Math.hypot(second.at[0] - first.at[0], second.at[1] - first.at[1]);
  const digits = (value: number): number => Number(value.toPrecision(4));
  const length = digits(PART * whole);
  const number = slidersOf(scene).length;
  const moving = { speed: digits(0.1 * whole) };
  const drive = isDrawn(scene) ? moving : { position: digits(whole - length), ...moving };
  const edits: Edit[] = [
    ...first.before,
    ...second.before,
    { add_link: { points: [{ name: first.name, at: first.at }, { name: head, at: between(PART) }] } },
    { add_link: { points: [{ name: piston, at: between(1 - PART) }, { name: second.name, at: second.at }] } },
    { add_slider: { link: rod, at: piston, on: barrel, along: joined(first.name, head) } },
    { set: ["sliders", number, "drive"], value: drive },
  ];
  if (isDrawn(scene)) return edits;
  // Places are rounded for the mechanism's size: what the drive pushes has the lengths that fit its position.
  return [...edits, { set: ["links", barrel, "lengths"], value: { [joined(first.name, head)]: length } }, { set: ["links", rod, "lengths"], value: { [joined(piston, second.name)]: length } }];
}

/** A drive, or none where there was one: it turns a link about its fixed point, pushes a block along its guide. */
function driven({ scene, places, drafted }: Present, what: Press): Follows {
  const sliders = slidersOf(scene);
  const points = pointsOn(scene, what.link ?? "");
  const pivot = points.find((name) => groundOf(scene).includes(name));
  // A block lies over the ends of links: where these cannot be driven, it is meant.
  const own = sliders.findIndex((slider) => what.link !== null && at(slider, ["link"]) === what.link);
  const there = sliders.findIndex((slider) => what.point !== null && (at(slider, ["at"]) ?? at(slider, ["pin"])) === what.point);
  const index = own >= 0 ? own : pivot === undefined ? there : -1;
  const isDriven = index >= 0 && at(sliders[index], ["drive"]) !== undefined;
  if (isDriven) return [{ remove: ["sliders", index, "drive"] }];
  if (what.link === null && index < 0) return "needs_link";
  const link = what.link ?? "";
  const value = at(scene, ["links", link]);
  if (at(value, ["drive"]) !== undefined) return [{ remove: ["links", link, "drive"] }];
  if (pivot !== undefined && points.length > 0 && index < 0) {
    const [from, to] = points.map((name) => places.get(name));
    const angle = isDrawn(scene) ? {} : { angle: from !== undefined && to !== undefined ? degrees(from, to) : 60 };
    const drive = { ...angle, omega: 10 };
    return Array.isArray(value) ? [{ set: ["links", link], value: { points: value, drive } }] : [{ set: ["links", link, "drive"], value: drive }];
  }
  if (index < 0) return "needs_pivot";
  const all = [...places.values()];
  const size = Math.max(0, ...all.map(([x, y]) => Math.hypot(x - all[0]![0], y - all[0]![1])));
  const speed = Number((size / 5 || 100).toPrecision(1));
  const position = short(Number((drafted.sliders[index]?.position ?? 0).toPrecision(6)));
  return [{ set: ["sliders", index, "drive"], value: isDrawn(scene) ? { speed } : { position, speed } }];
}
