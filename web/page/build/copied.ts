/** Parts of a mechanism that are copied, and put in again elsewhere under new names. */
import type { Edit } from "../engine/types.ts";
import { freeLink, freePoint } from "../panels/mechanism/free_name.ts";
import { at, entries, groundOf, isDrawn, joined, linksOf, pointsOn, slidersOf, type Draft } from "../panels/parts/scene.ts";
import type { Present } from "./tools.ts";
import { short, type Place } from "./sight.ts";

/** What is chosen on the stage. */
export interface Chosen {
  points: ReadonlySet<string>;
  links: ReadonlySet<string>;
}

/** What was copied: links with their points and drives, fixed points, sliders between them. */
export interface Copied {
  places: [string, Place][];
  fixed: string[];
  /** By name: its points, and what the scene says of it. */
  links: [string, string[], unknown][];
  sliders: object[];
}

/** Links with all their points among the chosen ones, and all points that are chosen. */
export function copied({ scene, places }: Present, { points, links }: Chosen): Copied {
  const names = new Set([...points, ...[...links].flatMap((link) => pointsOn(scene, link))].filter((name) => places.has(name)));
  const whole = linksOf(scene).filter((link) => pointsOn(scene, link).length > 0 && pointsOn(scene, link).every((name) => names.has(name)));
  const taken = new Set([...whole, "ground"]);
  const all = slidersOf(scene);
  const sliders = all.filter((slider) => taken.has(String(at(slider, ["on"]))) && names.has(String(at(slider, ["at"]) ?? at(slider, ["pin"]))) && (at(slider, ["link"]) === undefined || taken.has(String(at(slider, ["link"])))));
  return {
    places: [...names].map((name) => [name, places.get(name)!]),
    fixed: groundOf(scene).filter((name) => names.has(name)),
    links: whole.map((link) => [link, pointsOn(scene, link), structuredClone(at(scene, ["links", link]))]),
    sliders: structuredClone(sliders) as object[],
  };
}

/** The changes that put them in, so far away; and the names that they get. */
export function pasted(scene: Draft, { places, fixed, links, sliders }: Copied, by: Place): { edits: Edit[]; chosen: Chosen } {
  const points = new Map<string, string>();
  for (const [name] of places) points.set(name, freePoint(scene, [...points.values()]));
  const numbers = new Map<string, string>([["ground", "ground"]]);
  for (const [link] of links) numbers.set(link, freeLink(scene, [...numbers.values()]));
  const moved = new Map(places.map(([name, [x, y]]): [string, Place] => [name, [short(x + by[0]), short(y + by[1])]]));
  const placed = (name: string): { name: string; at: Place } => ({ name: points.get(name)!, at: moved.get(name)! });
  const edits: Edit[] = [
    ...fixed.map((name): Edit => ({ add_point: { link: "ground", ...placed(name) } })),
    ...links.map(([, names]): Edit => ({ add_link: { points: names.map(placed) } })),
  ];
  // A link is what its original is, lengths and drive, and not measured anew.
  if (!isDrawn(scene)) for (const [link, names, entry] of links) {
    const own = Object.fromEntries(entries(entry).map(([key, value]) => [key, key === "points" ? names.map((name) => points.get(name)!) : key === "lengths" || key === "shape" ? measures(value, names, points) : value]));
    edits.push({ set: ["links", numbers.get(link)!], value: Array.isArray(entry) ? names.map((name) => points.get(name)!) : own });
  }
  const count = slidersOf(scene).length;
  const list = sliders.map((slider) => renamed(slider, points, numbers, by));
  if (list.length > 0 && count === 0) edits.push({ set: ["sliders"], value: list });
  else list.forEach((slider, index) => edits.push({ set: ["sliders", count + index], value: slider }));
  return { edits, chosen: { points: new Set(points.values()), links: new Set(links.map(([link]) => numbers.get(link)!)) } };
}

/** Lengths or places of a link under new names. */
function measures(table: unknown, names: string[], points: Map<string, string>): Record<string, unknown> {
  const renamed = (key: string): string => {
    const own = points.get(key);
    if (own !== undefined) return own;
    const ends = names.flatMap((a) => names.map((b) => [a, b] as const)).find(([a, b]) => [a + b, `${a}-${b}`].includes(key));
    return ends === undefined ? key : joined(points.get(ends[0])!, points.get(ends[1])!);
  };
  return Object.fromEntries(entries(table).map(([key, value]) => [renamed(key), value]));
}

/** A slider under new names, its guide as far away as the rest. */
function renamed(slider: object, points: Map<string, string>, links: Map<string, string>, [dx, dy]: Place): object {
  const isGround = at(slider, ["on"]) === "ground";
  const word = (key: string, value: unknown): unknown => {
    if (key === "link" || key === "on") return links.get(String(value)) ?? value;
    if (key === "at" || key === "pin") return points.get(String(value)) ?? value;
    if (key === "through" && Array.isArray(value) && isGround) return [short(Number(value[0]) + dx), short(Number(value[1]) + dy)];
    if (key === "through" && typeof value === "string") return points.get(value) ?? value;
    if (key === "along" && typeof value === "string") {
      const [from, to] = (value.includes("-") ? value.split("-") : [...value]).map((end) => points.get(end) ?? end);
      return from !== undefined && to !== undefined ? joined(from, to) : value;
    }
    return value;
  };
  return Object.fromEntries(Object.entries(slider).map(([key, value]) => [key, word(key, value)]));
}
