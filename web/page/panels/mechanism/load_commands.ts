/** What the form's buttons do about masses, forces, springs and friction. */
import { SHEETS, type Edit } from "../../engine/types.ts";
import { at, hasLoads, isDrawn, listOf, names, pointsOn, sliderName, slidersOf, unitsOf, type Draft } from "../parts/scene.ts";
import { added } from "../parts/edits.ts";
import type { Command, Present } from "./commands.ts";

/** The keys of a link that say of its mass. */
export const MASS_KEYS = ["mass", "weight", "inertia", "center"] as const;

/** The acceleration of free fall in lengths per s². */
const FREE_FALL: Record<string, number> = { mm: 9810, cm: 981, m: 9.81, in: 386.1, ft: 32.17 };

export const LOAD_COMMANDS: Record<string, Command> = {
  mass: (present, link) => {
    const { scene } = present;
    const value = at(scene, ["links", link!]);
    const given = { ...(Array.isArray(value) ? { points: value } : ((value ?? {}) as object)), mass: 1, center: middle(present, link!) };
    return [...withUnits(scene, ["mass", "force"]), ...withPanel(scene), { set: ["links", link!], value: given }];
  },
  force: ({ scene }, spot) => {
    const [on, point] = parts(spot!);
    return withLoad(scene, { on, at: point, force: [0, -100] });
  },
  couple: ({ scene }, on) => withLoad(scene, { on, couple: 1000 }),
  over: (present, index, gauge) => [{ set: ["forces", Number(index), "over"], value: { of: gauge, table: usualTable(present, gauge!) } }],
  spring: ({ scene, places }, from, to) => {
    const ends = [parts(from!), parts(to!)];
    const [a, b] = ends.map(([, point]) => places.get(point) ?? [0, 0]) as [[number, number], [number, number]];
    // Shorter than it is now, so that it pulls.
    const length = Number((0.8 * Math.hypot(b[0] - a[0], b[1] - a[1])).toPrecision(2));
    return [...withUnits(scene, ["force"]), ...withPanel(scene), added(scene, "springs", { between: ends, rate: 1, length })];
  },
  friction: ({ scene, places }, joint) => {
    const [where, name] = parts(joint!);
    if (where === "guide") return [added(scene, "friction", { guide: name, coefficient: 0.1 })];
    // A journal that can be seen beside the links.
    const all = [...places.values()];
    const size = Math.max(...[0, 1].map((axis) => Math.max(...all.map((place) => place[axis]!)) - Math.min(...all.map((place) => place[axis]!))));
    return [added(scene, "friction", { pin: name, coefficient: 0.1, radius: Number((0.05 * size).toPrecision(1)) })];
  },
  gravity: ({ scene }) => [{ set: ["gravity"], value: [0, -freeFall(scene)] }],
  drop_of: ({ scene }, list, index) => [{ remove: listOf(scene, list as "forces").length === 1 ? [list!] : [list!, Number(index)] }],
  spot: (present, form, link, ...path) => {
    const where = middle(present, link!);
    const value = form === "number" ? (typeof where === "number" ? where : 0) : Array.isArray(where) ? where : [typeof where === "number" ? where : 0, 0];
    return [{ set: path, value }];
  },
};

/** The scene with a further force or couple. */
export function withLoad(scene: Draft, load: object): Edit[] {
  return [...withUnits(scene, ["force"]), ...withPanel(scene), added(scene, "forces", load)];
}

/** A table to begin with: over an angle it acts at its beginning, over a stroke more and more. */
function usualTable({ scene, drafted }: Present, gauge: string): [number, number][] {
  const slider = slidersOf(scene).findIndex((each) => `position(${sliderName(each)})` === gauge);
  if (slider < 0) return [[0, 1], [180, 0], [360, 1]];
  const position = drafted.sliders[slider]?.position ?? 0;
  const far = Number((Math.abs(position) / 4 || 10).toPrecision(1));
  return [[-far, 0], [far, 1]].map(([way, factor]): [number, number] => [Number((position + way!).toPrecision(3)), factor!]);
}

/** A link and its point, written `link:point`. */
function parts(spot: string): [string, string] {
  const [link = "", point = ""] = spot.split(":");
  return [link, point];
}

/** The units of these that the scene lacks. */
function withUnits(scene: Draft, wanted: ("mass" | "force")[]): Edit[] {
  const isFoot = ["in", "ft"].includes(unitsOf(scene).length);
  const usual = isFoot ? { mass: "lb", force: "lbf" } : { mass: "kg", force: "N" };
  return wanted.filter((unit) => at(scene, ["units", unit]) === undefined).map((unit) => ({ set: ["units", unit], value: usual[unit] }));
}

/** Shows the force plan with the first load, for loads are drawn beside it alone. */
function withPanel(scene: Draft): Edit[] {
  const given = at(scene, ["figure", "panels"]);
  const panels = given === undefined ? SHEETS.filter(({ isUsual }) => isUsual).map(({ key }) => key as string) : names(given);
  if (hasLoads(scene) || panels.includes("forces") || panels.includes("lever")) return [];
  return [{ set: ["figure", "panels"], value: [...panels, "forces"] }];
}

function freeFall(scene: Draft): number {
  const perSecond = FREE_FALL[unitsOf(scene).length] ?? 9.81;
  return at(scene, ["units", "time"]) === "min" ? 3600 * perSecond : perSecond;
}

/** The middle of a link: of its axis, in a drawn scene between its first two points; of a link with one point that. */
function middle({ scene, places }: Present, link: string): number | [number, number] | string {
  const points = pointsOn(scene, link);
  const [from, to] = points.map((name) => places.get(name));
  if (from === undefined || to === undefined) return points[0] ?? 0;
  const round = (value: number): number => Number(value.toPrecision(4));
  if (isDrawn(scene) || link === "ground") return [round((from[0] + to[0]) / 2), round((from[1] + to[1]) / 2)];
  return round(Math.hypot(to[0] - from[0], to[1] - from[1]) / 2);
}
