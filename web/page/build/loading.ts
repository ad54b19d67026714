/** The tool that loads links: a force from where it is pressed to where it is let go, a couple where it is tapped. */
import { withLoad } from "../panels/mechanism/load_commands.ts";
import { at, entries, isDrawn, linksOf, pointsOn, unitsOf } from "../panels/parts/scene.ts";
import { onLink } from "./hit.ts";
import { short, type Place } from "./sight.ts";
import type { Follows, Present, Press } from "./tools.ts";

/** So many units of force are one step of the grid: loads have no scale, and their numbers are typed where others are wanted. */
const FOR_A_STEP = 10;

/** The link that is loaded: of a joint the last one that has it, as what people load follows mostly there. */
function loadedLink({ scene }: Present, { point, link }: Press): string | null {
  if (point === null) return link;
  return linksOf(scene).findLast((name) => pointsOn(scene, name).includes(point)) ?? null;
}

/** Where on the link. */
function foot({ scene, places }: Present, link: string, { point, at: place, under }: Press): Place {
  return point !== null ? place : onLink(scene, places, link, under);
}

/** The force of a way over the stage, in the scene's unit; `null` where no link is pressed. */
function forceOf(present: Present, from: Press, to: Press): [number, number] | null {
  const link = loadedLink(present, from);
  if (link === null) return null;
  const begin = foot(present, link, from);
  return [0, 1].map((axis) => Math.round((to.under[axis]! - begin[axis]!) / present.grain) * FOR_A_STEP) as [number, number];
}

/** Its size with unit, and its direction. */
export function forceWords(present: Present, from: Press, to: Press): string {
  const [x, y] = forceOf(present, from, to) ?? [0, 0];
  const angle = (Math.atan2(y, x) * 180) / Math.PI;
  return `${Number(Math.hypot(x, y).toPrecision(3))} ${unitsOf(present.scene).forces}, ${angle.toFixed(1)}°`.replace("-", "−");
}

/** A force, or a couple where both presses are one. */
export function loaded(present: Present, from: Press, to: Press): Follows {
  const on = loadedLink(present, from);
  if (on === null) return "needs_link";
  if (from === to) return withLoad(present.scene, { on, couple: 1000 });
  const force = forceOf(present, from, to) ?? [0, 0];
  if (force.every((part) => part === 0)) return "needs_way";
  return withLoad(present.scene, { on, at: placeOn(present, on, from), force });
}

/** A place of a link as the scene says it: a point of it, a distance along it, or coordinates in its own frame, of a drawn scene in the fixed one. */
export function placeOn(present: Present, link: string, press: Press): string | number | Place {
  if (press.point !== null) return press.point;
  const { scene } = present;
  const rounded = (place: number[]): Place => place.map((value) => short(Number(value.toPrecision(4)))) as Place;
  const spot = foot(present, link, press);
  if (isDrawn(scene)) return rounded(spot);
  const points = pointsOn(scene, link);
  const frame = frameOf(present, link);
  if (frame === null) return points[0] ?? 0;
  const { local, fixed, turn } = frame;
  const way = turnedBy([spot[0] - fixed[0], spot[1] - fixed[1]], turn);
  const own = rounded([local[0] + way[0], local[1] + way[1]]);
  return points.length === 2 && at(scene, ["links", link, "shape"]) === undefined ? own[0] : own;
}

/** Where a distance along a link, or coordinates in its own frame, is in the fixed one; null where that is not known. */
export function fixedOn(present: Present, link: string, where: number | Place): Place | null {
  if (isDrawn(present.scene)) return Array.isArray(where) ? where : null;
  const frame = frameOf(present, link);
  if (frame === null) return null;
  const { local, fixed, turn } = frame;
  const [x, y] = Array.isArray(where) ? where : [where, 0];
  const way = turnedBy([x - local[0], y - local[1]], -turn);
  return [fixed[0] + way[0], fixed[1] + way[1]];
}

/** By how much a direction is turned, in radians, from the fixed frame into a link's own; null where that is not known. */
export function turnOf(present: Present, link: string): number | null {
  return isDrawn(present.scene) ? 0 : frameOf(present, link)?.turn ?? null;
}

export function turnedBy([x, y]: Place, angle: number): Place {
  return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
}

/** A place of a link in its own frame and in the fixed one, and the angle from that to this. */
function frameOf({ scene, places }: Present, link: string): { local: Place; fixed: Place; turn: number } | null {
  const shape = at(scene, ["links", link, "shape"]);
  const own = (local: unknown): Place => (Array.isArray(local) ? (local as Place) : [Number(local), 0]);
  const known = (shape === undefined ? [] : entries(shape)).flatMap(([name, local]): [Place, Place][] => (places.has(name) ? [[own(local), places.get(name)!]] : []));
  const [first, second] = pointsOn(scene, link).map((name) => places.get(name));
  if (shape === undefined && first !== undefined && second !== undefined) known.push([[0, 0], first], [[Math.hypot(second[0] - first[0], second[1] - first[1]), 0], second]);
  const [one, other] = [known[0], known.at(-1)];
  if (one === undefined || other === undefined || one === other) return null;
  const angle = (from: Place, to: Place): number => Math.atan2(to[1] - from[1], to[0] - from[0]);
  return { local: one[0], fixed: one[1], turn: angle(one[0], other[0]) - angle(one[1], other[1]) };
}
