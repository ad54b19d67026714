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
function placeOn(present: Present, link: string, press: Press): string | number | Place {
  if (press.point !== null) return press.point;
  const { scene, places } = present;
  const rounded = (place: number[]): Place => place.map((value) => short(Number(value.toPrecision(4)))) as Place;
  const spot = foot(present, link, press);
  if (isDrawn(scene)) return rounded(spot);
  const shape = at(scene, ["links", link, "shape"]);
  const own = (local: unknown): Place => (Array.isArray(local) ? (local as Place) : [Number(local), 0]);
  const known = (shape === undefined ? [] : entries(shape)).flatMap(([name, local]): [Place, Place][] => (places.has(name) ? [[own(local), places.get(name)!]] : []));
  const points = pointsOn(scene, link);
  const [first, second] = points.map((name) => places.get(name));
  if (shape === undefined && first !== undefined && second !== undefined) known.push([[0, 0], first], [[Math.hypot(second[0] - first[0], second[1] - first[1]), 0], second]);
  const [one, other] = [known[0], known.at(-1)];
  if (one === undefined || other === undefined || one === other) return points[0] ?? 0;
  const angle = (from: Place, to: Place): number => Math.atan2(to[1] - from[1], to[0] - from[0]);
  const turn = angle(one[0], other[0]) - angle(one[1], other[1]);
  const [x, y] = [spot[0] - one[1][0], spot[1] - one[1][1]];
  const local = rounded([one[0][0] + x * Math.cos(turn) - y * Math.sin(turn), one[0][1] + x * Math.sin(turn) + y * Math.cos(turn)]);
  return points.length === 2 && shape === undefined ? local[0] : local;
}
