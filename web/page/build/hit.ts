/** What is at a place of the stage. */
import type { Drafted } from "../engine/types.ts";
import { linksOf, pointsOn, type Draft } from "../panels/parts/scene.ts";
import type { Place } from "./sight.ts";

/** Places of points, by name. */
export type Places = ReadonlyMap<string, Place>;

export function placesIn(drafted: Drafted): Places {
  return new Map(drafted.points.map(({ name, at }): [string, Place] => [name, at]));
}

/** The point at a place. */
export function pointAt(places: Places, [x, y]: Place, reach: number): string | null {
  let found: string | null = null;
  let least = reach;
  for (const [name, [u, v]] of places) {
    const distance = Math.hypot(u - x, v - y);
    if (distance <= least) [found, least] = [name, distance];
  }
  return found;
}

/** The link at a place: that with the nearest side, or the area that it is in; a block reaches so far around its point. */
export function linkAt(scene: Draft, places: Places, place: Place, reach: number, block: number): string | null {
  let found: string | null = null;
  let least = reach;
  for (const name of linksOf(scene)) {
    const away = distanceOf(placesOf(scene, places, name), place, block);
    if (away < least || (away === 0 && found === null)) [found, least] = [name, away];
  }
  return found;
}

/** The known places of a link's points. */
export function placesOf(scene: Draft, places: Places, link: string): Place[] {
  return pointsOn(scene, link).flatMap((point) => (places.has(point) ? [places.get(point)!] : []));
}

/** The place on a link's sides that is nearest. */
export function onLink(scene: Draft, places: Places, link: string, place: Place): Place {
  const feet = sides(placesOf(scene, places, link)).map(([a, b]) => foot(place, a, b));
  const away = ([x, y]: Place): number => Math.hypot(x - place[0], y - place[1]);
  return feet.reduce((best, next) => (away(next) < away(best) ? next : best), feet[0] ?? place);
}

function distanceOf(corners: Place[], place: Place, block: number): number {
  const [only] = corners;
  if (only === undefined) return Infinity;
  // A block lies over the ends of other links: those come first.
  if (corners.length === 1) return Math.hypot(only[0] - place[0], only[1] - place[1]) <= block ? block / 4 : Infinity;
  if (triangles(corners).some((corner) => isIn(place, corner))) return 0;
  return Math.min(...sides(corners).map(([a, b]) => distance(place, a, b)));
}

/** All straight lines between two points: what is drawn is among them. */
function sides(corners: Place[]): [Place, Place][] {
  return corners.flatMap((a, index) => corners.slice(index + 1).map((b): [Place, Place] => [a, b]));
}

function triangles(corners: Place[]): [Place, Place, Place][] {
  return sides(corners).flatMap(([a, b]) => corners.filter((c) => c !== a && c !== b).map((c): [Place, Place, Place] => [a, b, c]));
}

function isIn([x, y]: Place, [a, b, c]: [Place, Place, Place]): boolean {
  const side = ([ax, ay]: Place, [bx, by]: Place): number => (bx - ax) * (y - ay) - (by - ay) * (x - ax);
  const [first, second, third] = [side(a, b), side(b, c), side(c, a)];
  return (first > 0 && second > 0 && third > 0) || (first < 0 && second < 0 && third < 0);
}

/** How far a place is from a side. */
export function distance(place: Place, a: Place, b: Place): number {
  const [x, y] = foot(place, a, b);
  return Math.hypot(place[0] - x, place[1] - y);
}

/** The place of a side that is nearest. */
function foot([x, y]: Place, [ax, ay]: Place, [bx, by]: Place): Place {
  const [ux, uy] = [bx - ax, by - ay];
  const square = ux * ux + uy * uy;
  const part = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / square));
  return [ax + part * ux, ay + part * uy];
}
