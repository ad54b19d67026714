/** How many motions a mechanism is free to make, counted as it is taught: what it needs to be complete. */
import { allPoints, at, groundOf, linksOf, pointsOn, type Draft } from "../panels/parts/scene.ts";

export interface Mobility {
  links: number;
  /** What joints take away. */
  taken: number;
  /** Three for each link, less what joints take away. */
  free: number;
  drives: number;
}

/** A pin takes two for each link beyond its first, a block on a guide two, a pin in a slot one. */
export function mobility(scene: Draft): Mobility {
  const links = linksOf(scene);
  const bodies = new Map(allPoints(scene).map((name) => [name, 0]));
  for (const carrier of ["ground", ...links]) for (const name of pointsOn(scene, carrier)) bodies.set(name, (bodies.get(name) ?? 0) + 1);
  const sliders: unknown[] = Array.isArray(scene["sliders"]) ? scene["sliders"] : [];
  const pins = [...bodies.values()].reduce((sum, count) => sum + 2 * Math.max(0, count - 1), 0);
  const taken = pins + sliders.reduce<number>((sum, slider) => sum + (at(slider, ["pin"]) === undefined ? 2 : 1), 0);
  const driven = [...links.map((name) => at(scene, ["links", name])), ...sliders].filter((part) => at(part, ["drive"]) !== undefined);
  return { links: links.length, taken, free: 3 * links.length - taken, drives: driven.length };
}

/** Whether anything stands still. */
export function hasGround(scene: Draft): boolean {
  const sliders: unknown[] = Array.isArray(scene["sliders"]) ? scene["sliders"] : [];
  return groundOf(scene).length > 0 || sliders.some((slider) => at(slider, ["on"]) === "ground");
}
