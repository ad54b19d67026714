/** Loads that are there: where the stage shows them, and what follows where they are dragged. */
import type { Edit } from "../engine/types.ts";
import { at, listOf, pointsOn, unitsOf } from "../panels/parts/scene.ts";
import { distance, placesOf, pointAt } from "./hit.ts";
import { fixedOn, placeOn, turnedBy, turnOf } from "./loading.ts";
import { short, type Place } from "./sight.ts";
import type { Present } from "./tools.ts";

/** The length of a force's arrow and the radius of a couple's arc in the engine's picture, in mm. */
const ARROW = 12;
const RADIUS = 3.6;
/** The part of an arrow that is taken hold of to move it: at its ends are a joint and its tip. */
const SHAFT = [0.3, 0.8] as const;
/** A step of the grid changes a force by at least so much, a couple by ten times that; large ones by a tenth of their power of ten. */
const LEAST = 10;

/** What is taken hold of: the tip of a force for its size and direction, its shaft for its place, a couple for its size. */
export interface LoadPress {
  index: number;
  part: "tip" | "shaft" | "couple";
  /** Where it is. */
  at: Place;
}

/** A load on the stage. */
interface Seen {
  index: number;
  on: string;
  /** Where it acts. */
  spot: Place;
  /** Its force in the fixed frame; of a couple none. */
  force: Place | null;
  couple: number;
}

const plus = (a: Place, b: Place, times: number): Place => [a[0] + times * b[0], a[1] + times * b[1]];

/** A force as the scene writes it: by components, or by size and direction. */
function vector(value: unknown): Place | null {
  if (Array.isArray(value)) return value.map(Number) as Place;
  const [size, angle] = [at(value, ["size"]), at(value, ["angle"])];
  return typeof size === "number" && typeof angle === "number" ? turnedBy([size, 0], (angle * Math.PI) / 180) : null;
}

/** All loads whose places are known. */
function seenLoads(present: Present): Seen[] {
  const { scene, places } = present;
  return listOf(scene, "forces").flatMap((load, index): Seen[] => {
    const on = String(at(load, ["on"]) ?? "");
    const where = at(load, ["at"]);
    const corners = placesOf(scene, places, on);
    const middle = corners.length === 0 ? null : (corners.reduce((sum, corner) => plus(sum, corner, 1 / corners.length), [0, 0] as Place));
    const spot = typeof where === "string" ? places.get(where) ?? null : where === undefined ? middle : fixedOn(present, on, where as number | Place);
    const own = vector(at(load, ["force"]));
    const turn = at(load, ["turns"]) === true ? turnOf(present, on) : 0;
    if (spot === null || turn === null) return [];
    const force = own === null ? null : turnedBy(own, -turn);
    return [{ index, on, spot, force, couple: Number(at(load, ["couple"]) ?? 0) }];
  });
}

/** What can be taken hold of; `mm` is a millimetre of the picture in units of length. */
export function handlesOf(present: Present, mm: number): LoadPress[] {
  return seenLoads(present).flatMap(({ index, spot, force }): LoadPress[] => {
    const size = force === null ? 0 : Math.hypot(...force);
    if (force === null || size === 0) return [{ index, part: "couple", at: plus(spot, [1, 0], RADIUS * mm) }];
    const along = plus([0, 0], force, (ARROW * mm) / size);
    return [{ index, part: "tip", at: plus(spot, along, 1) }, { index, part: "shaft", at: plus(spot, along, (SHAFT[0] + SHAFT[1]) / 2) }];
  });
}

/** What of a load is at a place, and how far away: of a couple all of its arc, of a force its tip and its shaft. */
export function loadAt(present: Present, mm: number, place: Place, reach: number): { load: LoadPress; away: number } | null {
  let found: { load: LoadPress; away: number } | null = null;
  const seen = new Map(seenLoads(present).map((load) => [load.index, load]));
  for (const load of handlesOf(present, mm)) {
    const { spot } = seen.get(load.index)!;
    const fromSpot = Math.hypot(place[0] - spot[0], place[1] - spot[1]);
    const half = plus(load.at, spot, -1);
    const ends = SHAFT.map((part) => plus(spot, half, part / ((SHAFT[0] + SHAFT[1]) / 2))) as [Place, Place];
    const away = load.part === "couple" ? Math.abs(fromSpot - RADIUS * mm) : load.part === "shaft" ? distance(place, ...ends) : Math.hypot(place[0] - load.at[0], place[1] - load.at[1]);
    if (away <= reach && (found === null || away < found.away)) found = { load, away };
  }
  return found;
}

/** What a step of the grid changes a number by. */
function stepOf(number: number, least: number): number {
  return Math.max(least, 10 ** (Math.floor(Math.log10(Math.abs(number) || 1)) - 1));
}

/** So many steps of the grid: whole ones where it is on. */
const stepsOf = (way: number, { grain, isOnGrid }: Held): number => (isOnGrid ? Math.round(way / grain) : Math.round((way / grain) * 10) / 10);

const rounded = (value: number): number => short(Number(value.toPrecision(6)));

/** What a drag changes. */
export interface Dragged {
  edits: Edit[];
  /** What is there now, in words. */
  words: string;
  /** A line from where the load acts. */
  from: Place;
  to: Place;
}

/** What is there, and whether the grid is on. */
type Held = Present & { isOnGrid: boolean };

/** What follows where a load is dragged so far; null where nothing is left of it. */
export function dragged(present: Held, load: LoadPress, by: Place): Dragged | null {
  const seen = seenLoads(present).find(({ index }) => index === load.index);
  if (seen === undefined) return null;
  const to = plus(load.at, by, 1);
  if (load.part === "tip") return forced(present, seen, by, to);
  return load.part === "shaft" ? moved(present, seen, by, to) : twisted(present, seen, by, to);
}

function forced(present: Held, { index, on, spot, force }: Seen, by: Place, to: Place): Dragged | null {
  const { scene } = present;
  const path = ["forces", index, "force"];
  const before = force ?? [0, 0];
  const step = stepOf(Math.hypot(...before), LEAST);
  const now = before.map((part, axis) => rounded(part + stepsOf(by[axis]!, present) * step)) as Place;
  const size = Math.hypot(...now);
  if (size === 0) return null;
  const angle = (Math.atan2(now[1], now[0]) * 180) / Math.PI;
  const turn = at(scene, ["forces", index, "turns"]) === true ? turnOf(present, on) ?? 0 : 0;
  const own = turnedBy(now, turn);
  const digits = (value: number): number => short(Number(value.toPrecision(4)));
  const value = Array.isArray(at(scene, path)) ? own.map((part) => (turn === 0 ? part : digits(part))) : { size: digits(size), angle: short(Math.round((angle + (turn * 180) / Math.PI) * 10) / 10) };
  const words = `${digits(size)} ${unitsOf(scene).forces}, ${angle.toFixed(1)}°`.replace("-", "−");
  return { edits: [{ set: path, value }], words, from: spot, to };
}

/** A force goes along its link, and comes to rest at its points. */
function moved(present: Present, { index, on, spot }: Seen, by: Place, to: Place): Dragged {
  const { scene, places, grain } = present;
  const under = plus(spot, by, 1);
  const own = new Map(pointsOn(scene, on).flatMap((name): [string, Place][] => (places.has(name) ? [[name, places.get(name)!]] : [])));
  const near = pointAt(own, under, 1.5 * grain);
  const point = near ?? (own.size < 2 ? [...own.keys()][0] ?? null : null);
  const place = placeOn(present, on, { at: point === null ? under : own.get(point)!, under, point, link: on });
  return { edits: [{ set: ["forces", index, "at"], value: place }], words: typeof place === "string" ? place : [place].flat().join(", "), from: under, to };
}

/** Up and to the right a couple turns more counter-clockwise. */
function twisted(present: Held, { index, spot, couple }: Seen, by: Place, to: Place): Dragged | null {
  const now = rounded(couple + stepsOf(by[0] + by[1], present) * stepOf(couple, 10 * LEAST));
  if (now === 0) return null;
  const { forces, length } = unitsOf(present.scene);
  return { edits: [{ set: ["forces", index, "couple"], value: now }], words: `${now} ${forces}·${length}`.replace("-", "−"), from: spot, to };
}
