import type { SceneFile } from "../../engine/types.ts";
import type { Sheet } from "../../sheets.ts";

/** A scene as somebody is writing it: any part may be missing still, and what stands there need not be what it should. */
export type Draft = Partial<SceneFile>;

/** Where a value of the scene is. */
export type Path = (string | number)[];

/** What stands at a path; undefined where nothing does. */
export function at(scene: unknown, path: Path): unknown {
  let value = scene;
  for (const key of path) {
    if (typeof value !== "object" || value === null || !Object.hasOwn(value, key)) return undefined;
    value = (value as Record<string | number, unknown>)[key];
  }
  return value;
}

/** The path as messages have it. */
export function dotted(path: Path): string {
  return path.join(".");
}

/** The entries of an object of the scene without remarks; none of anything else. */
export function entries(value: unknown): [string, unknown][] {
  if (typeof value !== "object" || value === null || Array.isArray(value)) return [];
  return Object.entries(value).filter(([key]) => key !== "note");
}

/** The texts of a list. */
export function names(value: unknown): string[] {
  return Array.isArray(value) ? value.filter((name): name is string => typeof name === "string") : [];
}

/** The scene of a text; null where it is no JSON object. Nothing is checked: that is the engine's. */
export function parsed(text: string): Draft | null {
  try {
    const scene: unknown = JSON.parse(text.replace(/^\uFEFF/, ""));
    return typeof scene === "object" && scene !== null && !Array.isArray(scene) ? (scene as Draft) : null;
  } catch {
    return null;
  }
}

/** The points of a link. */
export function pointsOf(link: unknown): string[] {
  if (Array.isArray(link)) return names(link);
  const points = at(link, ["points"]);
  return points === undefined ? entries(at(link, ["shape"])).map(([name]) => name) : names(points);
}

/** The names of the ground's points. */
export function groundOf(scene: Draft): string[] {
  const ground = scene["ground"];
  return Array.isArray(ground) ? names(ground) : entries(ground).map(([name]) => name);
}

/** The names of the links. */
export function linksOf(scene: Draft): string[] {
  return entries(scene["links"]).map(([name]) => name);
}

/** The scene's lists of joints and of loads. */
export type List = "sliders" | "gears" | "contacts" | "forces" | "springs" | "friction";

/** The entries of one of them; none where that is no list yet. */
export function listOf(scene: Draft, key: List): readonly unknown[] {
  return Array.isArray(scene[key]) ? scene[key] : [];
}

/** The sliders. */
export function slidersOf(scene: Draft): readonly unknown[] {
  return listOf(scene, "sliders");
}

/** The name of a slider in those of quantities and joints, as `3/ground`. */
export function sliderName(slider: unknown): string {
  return `${at(slider, ["link"]) ?? at(slider, ["pin"])}/${at(slider, ["on"])}`;
}

/** Whether something loads a link. */
export function hasLoads(scene: Draft): boolean {
  const isHeavy = ([, link]: [string, unknown]): boolean => at(link, ["mass"]) !== undefined || at(link, ["weight"]) !== undefined;
  return listOf(scene, "forces").length > 0 || listOf(scene, "springs").length > 0 || entries(scene["links"]).some(isHeavy);
}

/** The points of a link, or of `"ground"`. */
export function pointsOn(scene: Draft, carrier: string): string[] {
  return carrier === "ground" ? groundOf(scene) : pointsOf(at(scene, ["links", carrier]));
}

/** All points, each once. */
export const allPoints = once((scene: Draft): string[] => {
  const points = [...groundOf(scene), ...linksOf(scene).flatMap((link) => pointsOn(scene, link))];
  return [...new Set([...points, ...entries(scene["points"]).map(([name]) => name)])];
});

/** What is found by going through a whole scene, for a scene that stays as it is: found once, for every card asks for it. */
export function once<Found>(find: (scene: Draft) => Found): (scene: Draft) => Found {
  const found = new WeakMap<Draft, Found>();
  return (scene) => {
    if (!found.has(scene)) found.set(scene, find(scene));
    return found.get(scene)!;
  };
}

/** Whether the scene is drawn: given by coordinates in place of lengths. */
export function isDrawn(scene: Draft): boolean {
  return scene["points"] !== undefined;
}

/** Two names as one key: `AB`, or `A1-B1`. */
export function joined(a: string, b: string): string {
  return a.length === 1 && b.length === 1 ? a + b : `${a}-${b}`;
}

/** The key of the length between two points as a table of lengths writes it, else as it would be written. */
export function lengthKey(lengths: unknown, a: string, b: string): string {
  const ways = [joined(a, b), joined(b, a), `${a}-${b}`, `${b}-${a}`, a + b, b + a];
  return ways.find((key) => at(lengths, [key]) !== undefined) ?? joined(a, b);
}

/** Pairs of a list: neighbours, and of three the last with the first. */
export function pairs(points: string[]): [string, string][] {
  const found = points.slice(1).map((point, index): [string, string] => [points[index]!, point]);
  return points.length === 3 ? [...found, [points[0]!, points[2]!]] : found;
}

/** The largest coordinate or length that the scene gives, for sensible steps. */
export const sizeOf = once((scene: Draft): number => {
  const numbers = (value: unknown): number[] =>
    typeof value === "number" ? [Math.abs(value)] : typeof value === "object" && value !== null ? Object.values(value).flatMap(numbers) : [];
  const links = entries(scene["links"]).flatMap(([, link]) => [at(link, ["lengths"]), at(link, ["shape"])]);
  return Math.max(0, ...[scene["ground"], scene["points"], ...links].flatMap(numbers));
});

/** Units of the scene, by what is measured. */
export interface Units {
  length: string;
  velocity: string;
  acceleration: string;
  omega: string;
  alpha: string;
  mass: string;
  forces: string;
}

export function unitsOf(scene: Draft): Units {
  const length = String(at(scene, ["units", "length"]) ?? "");
  const time = String(at(scene, ["units", "time"]) ?? "");
  return {
    length,
    velocity: `${length}/${time}`,
    acceleration: `${length}/${time}²`,
    omega: `rad/${time}`,
    alpha: `rad/${time}²`,
    mass: String(at(scene, ["units", "mass"]) ?? ""),
    forces: String(at(scene, ["units", "force"]) ?? ""),
  };
}

/** The sheets that a figure has only where it asks for them. */
export const LATER: readonly Sheet[] = ["centers", "forces", "lever", "speeds"];

/** The unit of what a sheet shows. */
export function unitOn(units: Units, sheet: Sheet): string {
  if (sheet === "lever") return units.velocity;
  return sheet === "scheme" || sheet === "centers" || sheet === "speeds" ? units.length : units[sheet];
}
