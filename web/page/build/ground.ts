/** What lies behind the mechanism: the grid with numbers at its edges, and a photograph. */
import { svgElement } from "../dom/element.ts";
import type { Pixels, Place, Sight } from "./sight.ts";

/** Lines of the grid, and numbers along its lower and left edge. */
export function gridShapes(sight: Sight, unit: string): SVGElement[] {
  const { fine, named } = sight.grid();
  const { width, height } = sight.size;
  const [low, high] = [sight.toScene([0, height]), sight.toScene([width, 0])];
  const lines: Record<"fine" | "named", string[]> = { fine: [], named: [] };
  const texts: SVGElement[] = [];
  const every = Math.round(named / fine);
  for (const axis of [0, 1] as const)
    for (let count = Math.ceil(low[axis] / fine); count * fine <= high[axis]; count += 1) {
      const value = Number((count * fine).toPrecision(12));
      const [x, y] = sight.toPane(axis === 0 ? [value, 0] : [0, value]).map((pixel) => pixel.toFixed(1));
      const isNamed = count % every === 0;
      lines[isNamed ? "named" : "fine"].push(axis === 0 ? `M${x} 0V${height}` : `M0 ${y}H${width}`);
      // No number is cut at a corner or an edge.
      const hasRoom = axis === 0 ? Number(x) > 36 && Number(x) < width - 40 : Number(y) > 12 && Number(y) < height - 18;
      if (isNamed && hasRoom) texts.push(svgElement("text", axis === 0 ? { x, y: height - 5, "text-anchor": "middle" } : { x: 5, y: Number(y) + 4 }, `${value}`.replace("-", "−")));
    }
  const words = svgElement("text", { x: width - 6, y: height - 5, "text-anchor": "end", class: "unit" }, unit);
  return [svgElement("path", { d: lines.fine.join("") }), svgElement("path", { class: "named", d: lines.named.join("") }), ...texts, words];
}

/** A photograph behind the mechanism; it is kept in this tab alone. */
export interface Photograph {
  address: string;
  width: number;
  height: number;
  /** Where its upper left corner is, and how long one of its pixels is, in the scene's units. */
  corner: Place;
  pixel: number;
}

/** The picture in a file, as large as the stage shows it whole. */
export async function photographed(file: Blob, sight: Sight): Promise<Photograph> {
  const address = URL.createObjectURL(file);
  const image = new Image();
  image.src = address;
  try {
    await image.decode();
  } catch (why) {
    URL.revokeObjectURL(address);
    throw why;
  }
  const { naturalWidth: width, naturalHeight: height } = image;
  const shown = Math.min(sight.size.width / width, sight.size.height / height);
  const [wide, tall] = [width * shown, height * shown];
  const corner = sight.toScene([(sight.size.width - wide) / 2, (sight.size.height - tall) / 2]);
  return { address, width, height, corner, pixel: shown / sight.now.value.scale };
}

/** The photograph so that two of its places are so far apart; the first stays where it is. */
export function scaled(photo: Photograph, [first, second]: [Place, Place], length: number): Photograph {
  const now = Math.hypot(second[0] - first[0], second[1] - first[1]);
  if (!(now > 0) || !(length > 0)) return photo;
  const factor = length / now;
  const corner = [0, 1].map((axis) => first[axis]! + factor * (photo.corner[axis]! - first[axis]!)) as Place;
  return { ...photo, corner, pixel: photo.pixel * factor };
}

export function photoShape(photo: Photograph, sight: Sight): SVGElement {
  const [x, y] = sight.toPane(photo.corner);
  const pixel = photo.pixel * sight.now.value.scale;
  return svgElement("image", { href: photo.address, x, y, width: photo.width * pixel, height: photo.height * pixel, preserveAspectRatio: "none" });
}

/** A line with its length and its angle, while it is drawn. */
export function lineShapes(from: Pixels, to: Pixels, words: string): SVGElement[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const size = Math.max(Math.hypot(dx, dy), 1);
  // Above the line, and beside a steep one.
  const side = dx >= 0 ? 1 : -1;
  const off = 14;
  const [x, y] = [(from[0] + to[0]) / 2 + (off * side * dy) / size, (from[1] + to[1]) / 2 - (off * side * dx) / size];
  const anchor = Math.abs(dy) < 0.3 * size ? "middle" : side * dy < 0 ? "end" : "start";
  return [
    svgElement("path", { class: "way", d: `M${from[0]} ${from[1]}L${to[0]} ${to[1]}` }),
    svgElement("circle", { cx: to[0], cy: to[1], r: 4 }),
    svgElement("text", { x, y, "text-anchor": anchor }, words),
  ];
}
