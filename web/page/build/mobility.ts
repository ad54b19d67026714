/** How many motions a mechanism is free to make, counted as it is taught: what it needs to be complete. */
import type { Refused } from "../engine/types.ts";
import { allPoints, at, groundOf, isDrawn, linksOf, listOf, pointsOn, slidersOf, type Draft } from "../panels/parts/scene.ts";
import { said } from "../refused.ts";
import { say } from "./words.ts";

export interface Mobility {
  links: number;
  /** What joints take away. */
  taken: number;
  /** Three for each link, less what joints take away. */
  free: number;
  drives: number;
}

/** A pin takes two for each link beyond its first, a block on a guide two, a pin in a slot one; a pair of wheels and a contact of two profiles one. */
export function mobility(scene: Draft): Mobility {
  const links = linksOf(scene);
  const bodies = new Map(allPoints(scene).map((name) => [name, 0]));
  for (const carrier of ["ground", ...links]) for (const name of pointsOn(scene, carrier)) bodies.set(name, (bodies.get(name) ?? 0) + 1);
  const sliders = slidersOf(scene);
  const pins = [...bodies.values()].reduce((sum, count) => sum + 2 * Math.max(0, count - 1), 0);
  const rolling = listOf(scene, "gears").length + listOf(scene, "contacts").length;
  const taken = pins + rolling + sliders.reduce<number>((sum, slider) => sum + (at(slider, ["pin"]) === undefined ? 2 : 1), 0);
  const driven = [...links.map((name) => at(scene, ["links", name])), ...sliders].filter((part) => at(part, ["drive"]) !== undefined);
  return { links: links.length, taken, free: 3 * links.length - taken, drives: driven.length };
}

/** Whether anything stands still. */
export function hasGround(scene: Draft): boolean {
  const sliders = slidersOf(scene);
  return groundOf(scene).length > 0 || sliders.some((slider) => at(slider, ["on"]) === "ground");
}

/** What a mechanism that is refused lacks by the count of its motions; null where that is right, or not what is wrong. */
function missing(scene: Draft, { path }: Refused): string | null {
  // What is wrong in one place of the text has a path of its own.
  if (path !== "links") return null;
  const { links, taken, free, drives } = mobility(scene);
  if (links === 0) return say("begin");
  if (isDrawn(scene) || free === drives) return null;
  const count = say("mobility", { links, taken, free: String(free).replace("-", "−"), drives });
  if (free < drives) return `${say("too_held", { count: drives - free })} ${count}`;
  const wants = !hasGround(scene) ? "wants_ground" : free === drives + 1 ? "wants_one" : "wants_more";
  return `${say(wants, { count: free - drives })} ${count}`;
}

/** Whether a scene that is refused is only begun: nothing in it need be wrong. */
export function isBegun(scene: Draft, refused: Refused): boolean {
  return missing(scene, refused) !== null;
}

/** What is missing of a scene that is refused. */
export function unfinished(scene: Draft, refused: Refused): string {
  return missing(scene, refused) ?? say("incomplete", { why: said(refused) });
}
