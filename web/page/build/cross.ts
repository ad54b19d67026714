/** The cross on the stage, which keys move in place of a pointer. */
import { svgElement } from "../dom/element.ts";
import { linksOf, type Draft } from "../panels/parts/scene.ts";
import { placesOf, type Places } from "./hit.ts";
import { short, type Pixels, type Place } from "./sight.ts";
import type { Tool } from "./tools.ts";

const ARROWS: Record<string, Place> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const PAGES: Record<string, 1 | -1> = { PageDown: 1, PageUp: -1 };

/** Where a key takes the cross: an arrow by a step; the keys for pages to the next or last thing. Null for other keys. */
export function crossed(cross: Place, key: string, step: number, things: Place[]): Place | null {
  const arrow = ARROWS[key];
  if (arrow !== undefined) return cross.map((value, axis) => (arrow[axis] === 0 ? value : short((Math.round(value / step) + arrow[axis]!) * step))) as Place;
  const way = PAGES[key];
  if (way === undefined) return null;
  const now = things.findIndex((thing) => isAt(thing, cross));
  return things[now < 0 ? (way > 0 ? 0 : things.length - 1) : (now + way + things.length) % things.length] ?? cross;
}

export function isAt([x, y]: Place, [u, v]: Place): boolean {
  return x === u && y === v;
}

/** What the next press of a tool may take: points, and the middles of links. */
export function thingsFor(tool: Tool, scene: Draft, places: Places): Place[] {
  const middles = linksOf(scene).flatMap((link): Place[] => {
    const corners = placesOf(scene, places, link);
    // Of a triangle its middle, of a straight link a place off its own middle, where others cross less.
    const shares = corners.length === 2 ? [0.55, 0.45] : corners.map(() => 1 / corners.length);
    return corners.length < 2 ? [] : [[0, 1].map((axis) => corners.reduce((sum, corner, index) => sum + shares[index]! * corner[axis]!, 0)) as Place];
  });
  return tool === "drive" || tool === "third" ? [...middles, ...places.values()] : [...places.values(), ...middles];
}

/** The cross, with where it is. */
export function crossShape([x, y]: Pixels, words: string): SVGElement[] {
  return [svgElement("path", { d: `M${x - 11} ${y}h22M${x} ${y - 11}v22` }), svgElement("text", { x: x + 7, y: y + 19 }, words)];
}
