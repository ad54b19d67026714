/** Long lists, of which only what comes near to what is seen is built. */
import { element } from "./element.ts";

/** How many things are built together; the first of them at once. */
const CHUNK = 16;

export interface Chunks {
  roots: HTMLElement[];
  /** Builds the thing at this place, with those before and behind it in its chunk. */
  reach(index: number): void;
}

/** The elements of all things, each `height` high about; `built` is told of those that are built later; `empty` stands in their place until then. */
export function chunks<Thing>(things: Thing[], height: string, build: (thing: Thing) => HTMLElement, built: () => void = () => undefined, empty: () => HTMLElement = () => element("div")): Chunks {
  const waiting = new Map<number, HTMLElement>();
  const made = (chunk: number): HTMLElement[] => things.slice(chunk * CHUNK, (chunk + 1) * CHUNK).map(build);
  const fill = (chunk: number): void => {
    const place = waiting.get(chunk);
    if (place === undefined) return;
    waiting.delete(chunk);
    place.replaceWith(...made(chunk));
    built();
  };
  const observer = new IntersectionObserver((seen) => {
    for (const { target, isIntersecting } of seen) if (isIntersecting) observer.unobserve(target), fill(Number((target as HTMLElement).dataset["chunk"]));
  });
  const later: HTMLElement[] = [];
  for (let chunk = 1; chunk * CHUNK < things.length; chunk += 1) {
    const count = Math.min(CHUNK, things.length - chunk * CHUNK);
    const place = empty();
    place.dataset["chunk"] = String(chunk);
    place.style.height = `calc(${count} * ${height})`;
    waiting.set(chunk, place);
    observer.observe(place);
    later.push(place);
  }
  return { roots: [...made(0), ...later], reach: (index) => fill(Math.floor(index / CHUNK)) };
}
