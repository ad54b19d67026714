import type { App } from "../../app.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { allPoints, at, entries, parsed, type Draft } from "../parts/scene.ts";

/** Places of points in the scene's own coordinates, by name. */
export type Places = Map<string, [number, number]>;

/** Where the points are now: as the engine found them, else as far as the scene says. */
export function placesOf(app: App): Signal<Places> {
  const places = signal<Places>(new Map());
  app.history.now.on(({ text }) => {
    const scene = parsed(text);
    if (scene === null) return;
    // Points that a change leaves without a known place stay where they were seen last.
    const seen = [...places.value].filter(([name]) => allPoints(scene).includes(name));
    const show = (found: Places): void => {
      if (app.history.now.value.text === text) places.set(new Map([...seen, ...found]));
    };
    app.engine.places(text).then(
      (found) => show(new Map(found.map(({ name, at: place }) => [name, place]))),
      () => show(given(scene)),
    );
  });
  return places;
}

/** The places that a scene gives. */
function given(scene: Draft): Places {
  const tables = ["near", "points", "ground"].flatMap((key) => entries(at(scene, [key])));
  return new Map(tables.flatMap(([name, place]) => (isPlace(place) ? [[name, place]] : [])));
}

function isPlace(value: unknown): value is [number, number] {
  return Array.isArray(value) && value.length === 2 && value.every((number) => typeof number === "number");
}

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
