/** The mechanism on the drawing board, as far as places are known: lines, points and guides, no plans. */
import { svgElement } from "../../dom/element.ts";
import { at, groundOf, linksOf, pointsOn, type Draft } from "../parts/scene.ts";
import type { Places } from "./places.ts";

export type Place = [number, number];

/** What the board shows: a box in the scene's coordinates. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A box with room for all places; about 300 mm wide where there are none. */
export function boxOf(places: Places, unit: string, shape: number): Box {
  const room = { mm: 300, cm: 30, m: 0.3, in: 12, ft: 1 }[unit] ?? 300;
  const all = [...places.values()];
  const span = (axis: 0 | 1): [number, number] => {
    const along = all.map((place) => place[axis]);
    return along.length === 0 ? [0, 0] : [Math.min(...along), Math.max(...along)];
  };
  const [left, right] = span(0);
  const [low, high] = span(1);
  const width = Math.max((right - left) * 1.5, (high - low) * 1.5 * shape, room);
  const height = width / shape;
  const middle = all.length === 0 ? [room * 0.4, room * 0.2] : [(left + right) / 2, (low + high) / 2];
  return { x: middle[0]! - width / 2, y: middle[1]! - height / 2, width, height };
}

/** Whether all places are in the box, and not lost in it. */
export function holds(box: Box, places: Places): boolean {
  const margin = 0.04 * box.width;
  const isIn = ([x, y]: Place): boolean => x > box.x + margin && x < box.x + box.width - margin && y > box.y + margin && y < box.y + box.height - margin;
  const all = [...places.values()];
  const size = Math.max(0, ...all.map(([x, y]) => Math.max(Math.abs(x - all[0]![0]), Math.abs(y - all[0]![1]))));
  return all.every(isIn) && (all.length < 3 || size > 0.12 * box.width);
}

/** The distance of grid lines: 1, 2 or 5 with zeros, some twenty to the box. */
export function gridOf(box: Box): number {
  const rough = box.width / 20;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough) ?? rough;
}

/** What places are rounded to: 1, 2 or 5 with zeros, at most a quarter of the grid. */
export function grainOf(box: Box): number {
  const most = gridOf(box) / 4;
  const power = 10 ** Math.floor(Math.log10(most) + 1e-9);
  return [5, 2, 1].map((factor) => factor * power).find((step) => step <= most * (1 + 1e-9)) ?? power;
}

/** Everything on the board; `dot` is a length on the screen in the scene's units. */
export function sketch(scene: Draft, places: Places, box: Box, dot: number, chosen: string | null): SVGElement[] {
  const links = linksOf(scene).map((name) => linkShape(scene, places, name, dot, name === chosen));
  const points = [...places].map(([name, place]) => pointShape(name, place, groundOf(scene).includes(name), dot, name === chosen));
  return [gridLines(box), ...guides(scene, places, box), ...links, ...points];
}

function gridLines(box: Box): SVGElement {
  const step = gridOf(box);
  const lines: string[] = [];
  for (let x = Math.ceil(box.x / step) * step; x < box.x + box.width; x += step) lines.push(`M${x} ${-box.y}V${-box.y - box.height}`);
  for (let y = Math.ceil(box.y / step) * step; y < box.y + box.height; y += step) lines.push(`M${box.x} ${-y}H${box.x + box.width}`);
  return svgElement("path", { class: "grid", d: lines.join("") });
}

function linkShape(scene: Draft, places: Places, name: string, dot: number, isChosen: boolean): SVGElement {
  const corners = pointsOn(scene, name).flatMap((point) => (places.has(point) ? [places.get(point)!] : []));
  const isDriven = at(scene, ["links", name, "drive"]) !== undefined;
  const group = svgElement("g", { class: `link${isDriven ? " driven" : ""}${isChosen ? " chosen" : ""}` });
  const [first] = corners;
  if (first === undefined) return group;
  if (corners.length === 1) {
    // Of a link with more points, where the others are is not known.
    if (pointsOn(scene, name).length > 1) return group;
    group.append(svgElement("rect", { x: first[0] - 1.8 * dot, y: -first[1] - 1.1 * dot, width: 3.6 * dot, height: 2.2 * dot }));
    return group;
  }
  group.append(svgElement("polygon", { points: corners.map(([x, y]) => `${x},${-y}`).join(" ") }));
  const [x, y] = [0, 1].map((axis) => corners.reduce((sum, corner) => sum + corner[axis]!, 0) / corners.length) as Place;
  const text = svgElement("text", { x: x + 0.8 * dot, y: -y - 0.8 * dot, "font-size": 2.9 * dot });
  text.textContent = name;
  group.append(text);
  return group;
}

function pointShape(name: string, [x, y]: Place, isFixed: boolean, dot: number, isChosen: boolean): SVGElement {
  const group = svgElement("g", { class: `point${isChosen ? " chosen" : ""}` });
  if (isFixed) group.append(svgElement("path", { class: "pivot", d: `M${x} ${-y}l${-1.5 * dot} ${2.4 * dot}h${3 * dot}z` }));
  group.append(svgElement("circle", { cx: x, cy: -y, r: 0.75 * dot }));
  const text = svgElement("text", { x: x - 2.6 * dot, y: -y - 1.2 * dot, "font-size": 3.1 * dot });
  text.textContent = name;
  group.append(text);
  return group;
}

/** The guides of sliders on the ground and on links whose direction is told by two points or an angle on the ground. */
function guides(scene: Draft, places: Places, box: Box): SVGElement[] {
  const list: unknown[] = Array.isArray(scene["sliders"]) ? scene["sliders"] : [];
  return list.flatMap((slider) => {
    const place = places.get(String(at(slider, ["at"]) ?? at(slider, ["pin"])));
    const through = at(slider, ["through"]);
    const from = Array.isArray(through) && at(slider, ["on"]) === "ground" ? (through as Place) : (places.get(String(through)) ?? place);
    const direction = directionOf(slider, scene, places);
    if (from === undefined || direction === null) return [];
    const reach = box.width * 0.35;
    const [dx, dy] = direction.map((part) => part * reach) as Place;
    return [svgElement("line", { class: "guide", x1: from[0] - dx, y1: -from[1] + dy, x2: from[0] + dx, y2: -from[1] - dy })];
  });
}

function directionOf(slider: unknown, scene: Draft, places: Places): Place | null {
  const along = at(slider, ["along"]) ?? 0;
  const on = String(at(slider, ["on"]));
  if (typeof along === "number" && on === "ground") return [Math.cos((along * Math.PI) / 180), Math.sin((along * Math.PI) / 180)];
  if (Array.isArray(along) && on === "ground") return unit(along as Place);
  const [from, to] = pointsOn(scene, on).map((name) => places.get(name));
  return from === undefined || to === undefined ? null : unit([to[0] - from[0], to[1] - from[1]]);
}

function unit([x, y]: Place): Place | null {
  const size = Math.hypot(x, y);
  return size > 0 ? [x / size, y / size] : null;
}

/** The point at a place. */
export function pointAt(places: Places, [x, y]: Place, reach: number): string | null {
  const found = [...places].map(([name, place]): [string, number] => [name, Math.hypot(place[0] - x, place[1] - y)]).sort((a, b) => a[1] - b[1])[0];
  return found !== undefined && found[1] <= reach ? found[0] : null;
}

/** The link at a place: the one with the nearest side. */
export function linkAt(scene: Draft, places: Places, place: Place, reach: number): string | null {
  const found = linksOf(scene).map((name): [string, number] => {
    const corners = pointsOn(scene, name).flatMap((point) => (places.has(point) ? [places.get(point)!] : []));
    const sides = corners.map((corner, index): [Place, Place] => [corner, corners[(index + 1) % corners.length]!]);
    // A block lies over the ends of other links: those come first.
    return [name, Math.min(Infinity, ...sides.map(([a, b]) => distance(place, a, b))) + (corners.length === 1 ? reach / 4 : 0)];
  });
  const [nearest] = found.sort((a, b) => a[1] - b[1]);
  return nearest !== undefined && nearest[1] <= reach ? nearest[0] : null;
}

/** How far a place is from a side. */
function distance([x, y]: Place, [ax, ay]: Place, [bx, by]: Place): number {
  const [ux, uy] = [bx - ax, by - ay];
  const square = ux * ux + uy * uy;
  const part = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / square));
  return Math.hypot(x - ax - part * ux, y - ay - part * uy);
}
