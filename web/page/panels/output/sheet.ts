import { element } from "../../dom/element.ts";
import { isDark } from "../../layout/theme.ts";
import { forDark } from "../../picture/dark.ts";

/** A box on a sheet: x, y, width, height in mm. */
export type Box = [number, number, number, number];

/** A place for a picture of the engine. */
export interface Sheet {
  root: HTMLElement;
  /** Shows a picture, or the part of it in a box. */
  show(svg: string, part?: Box): void;
  /** Calls `listener` with each new picture, so that it may be marked. */
  drawn(listener: (picture: SVGSVGElement) => void): void;
}

const STYLE = "<style>svg { display: block; width: 100%; height: auto; margin: 0 auto; }</style>";

/**
 * A place for a picture, in a tree of its own, so that the ids in it meet no others of the page.
 *
 * `asPaper`: the picture keeps the colours of paper on a dark screen, too.
 */
export function sheet(asPaper: boolean, attributes: Record<string, string> = {}): Sheet {
  const root = element("div", { class: "drawn", ...attributes });
  const tree = root.attachShadow({ mode: "open" });
  const listeners: ((picture: SVGSVGElement) => void)[] = [];
  let last: [string, Box | undefined] | undefined;
  function show(svg: string, part?: Box): void {
    last = [svg, part];
    tree.innerHTML = STYLE + (isDark.value && !asPaper ? forDark(svg) : svg);
    const picture = tree.querySelector("svg");
    if (picture === null) return;
    nameBy(picture);
    if (part !== undefined) crop(picture, part);
    for (const listener of listeners) listener(picture);
  }
  if (!asPaper) isDark.on(() => last !== undefined && show(...last));
  return { root, show, drawn: (listener) => void listeners.push(listener) };
}

/** Gives title and description to those who cannot see it; they would show as a tip wherever the mouse rests. */
function nameBy(picture: SVGSVGElement): void {
  const parts = ["title", "desc"].map((name) => picture.querySelector(`:scope > ${name}`));
  picture.setAttribute("aria-label", parts.map((part) => part?.textContent ?? "").join(". "));
  for (const part of parts) part?.remove();
}

/** Shows a box of the sheet alone, no higher than `--tallest`. */
function crop(picture: SVGSVGElement, part: Box): void {
  const aspect = part[2] / part[3];
  picture.setAttribute("viewBox", part.join(" "));
  picture.removeAttribute("width");
  picture.removeAttribute("height");
  picture.style.aspectRatio = String(aspect);
  picture.style.width = `min(100%, var(--tallest, 100vh) * ${aspect})`;
}

/** Width and height of a sheet in mm, as its SVG says them. */
export function sizeOf(svg: string): [number, number] {
  const side = (name: string): number => Number(new RegExp(`^<svg[^>]* ${name}="([\\d.]+)mm"`).exec(svg)?.[1] ?? Number.NaN);
  return [side("width"), side("height")];
}

/** A box around places of the sheet, with room for feet and letters. */
export function boxAround(places: [number, number][]): Box | null {
  if (places.length < 2) return null;
  const [across, down] = [places.map(([x]) => x), places.map(([, y]) => y)];
  const [left, top] = [Math.min(...across), Math.min(...down)];
  const room = 13;
  return [left - room, top - room, Math.max(...across) - left + 2 * room, Math.max(...down) - top + 2 * room];
}
