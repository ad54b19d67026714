/** The cross on the drawing board, which keys move in place of a pointer. */
import { svgElement } from "../../dom/element.ts";
import { linksOf, pointsOn, type Draft } from "../parts/scene.ts";
import type { Begun, Tool } from "./board_tools.ts";
import type { Places } from "./places.ts";
import type { Box, Place } from "./sketch.ts";

const ARROWS: Record<string, Place> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const PAGES: Record<string, 1 | -1> = { PageDown: 1, PageUp: -1 };

/** Where a key takes the cross: an arrow by a step, within the board; the keys for pages to the next or last thing there. Null for other keys. */
export function moved(cross: Place, key: string, step: number, box: Box, things: Place[]): Place | null {
  const arrow = ARROWS[key];
  if (arrow !== undefined) {
    const [x, y] = cross.map((value, axis) => Number(((Math.round(value / step) + arrow[axis]!) * step).toPrecision(10))) as Place;
    return [Math.min(Math.max(x, box.x), box.x + box.width), Math.min(Math.max(y, box.y), box.y + box.height)];
  }
  const way = PAGES[key];
  if (way === undefined) return null;
  const now = things.findIndex((thing) => isAt(thing, cross));
  return things[now < 0 ? (way > 0 ? 0 : things.length - 1) : (now + way + things.length) % things.length] ?? cross;
}

export function isAt([x, y]: Place, [u, v]: Place): boolean {
  return x === u && y === v;
}

/** What the next press of a tool may take: points, or the middles of links' first sides. */
export function thingsFor(tool: Tool, begun: Begun | null, scene: Draft, places: Places): Place[] {
  const middles = linksOf(scene).flatMap((name): Place[] => {
    const [from, to] = pointsOn(scene, name).map((point) => places.get(point));
    return from === undefined || to === undefined ? [] : [[(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]];
  });
  const wantsLink = tool === "drive" || (tool === "third" && begun === null) || (tool === "block" && begun !== null);
  return tool === "drop" ? [...places.values(), ...middles] : wantsLink ? middles : [...places.values()];
}

/** The cross, with where it is. */
export function crossShape([x, y]: Place, dot: number, words: string): SVGElement[] {
  const arm = 2 * dot;
  return [
    svgElement("path", { d: `M${x - arm} ${-y}h${2 * arm}M${x} ${-y - arm}v${2 * arm}` }),
    svgElement("text", { x: x + dot, y: -y + 3.4 * dot, "font-size": 2.9 * dot }, words),
  ];
}
