import type { Places } from "../../build/hit.ts";

/** A place for a new point: beside the middle of others, or to the right of everything; the first is the origin. */
export function freshPlace(places: Places, beside: string[]): [number, number] {
  const all = [...places.values()];
  if (all.length === 0) return [0, 0];
  const size = Math.max(...all.flatMap(([x, y]) => all.map(([u, v]) => Math.hypot(x - u, y - v))));
  const space = size > 0 ? 0.7 * size : 100;
  const near = beside.flatMap((name) => (places.has(name) ? [places.get(name)!] : []));
  if (near.length === 0) return rounded([Math.max(...all.map(([x]) => x)) + space, all[0]![1]], space);
  const middle = [0, 1].map((axis) => near.reduce((sum, place) => sum + place[axis]!, 0) / near.length);
  return rounded([middle[0]! + (near.length === 1 ? 0.8 * space : 0), middle[1]! + 0.6 * space], space);
}

/** A place on round numbers, for points that lie about `space` apart. */
function rounded([x, y]: [number, number], space: number): [number, number] {
  const grain = 10 ** (Math.floor(Math.log10(space)) - 1);
  const round = (value: number): number => Number((Math.round(value / grain) * grain).toPrecision(12));
  return [round(x), round(y)];
}
