import type { App } from "../../app.ts";
import { svgElement } from "../../dom/element.ts";
import type { Curves, Drive, DriveAxis } from "../../engine/types.ts";
import type { Sheet } from "../output/sheet.ts";

/** Radius of the ring, in mm. */
const RING = 2.4;

/** A turn in degrees. */
const TURN = 360;

/** The drive's value, whole turns on, in a range; null where that holds none. */
function within(low: number, high: number, { value, is_angle }: Pick<Drive, "value" | "is_angle">): number | null {
  const turned = value + (is_angle ? TURN * Math.ceil((low - value) / TURN) : 0);
  return turned >= low && turned <= high ? turned : null;
}

/** Vertical lines through graphs at the drive's value, as a path. */
export function linesAt({ low, high, areas }: DriveAxis, drive: Pick<Drive, "value" | "is_angle">): string {
  const at = within(low, high, drive);
  if (at === null) return "";
  return areas.map(([x, y, width, height]) => `M${x + ((at - low) / (high - low)) * width} ${y}v${height}`).join("");
}

/** The places on ways at the drive's value. */
export function placesAt(ways: Curves["ways"], drive: Pick<Drive, "value" | "is_angle">): [number, number][] {
  return ways.flatMap((way) => {
    const at = within(way[0]![0], way.at(-1)![0], drive);
    const next = at === null ? -1 : way.findIndex(([value]) => value >= at);
    if (at === null || next < 0) return [];
    const [[from, x, y], [to, u, v]] = [way[Math.max(0, next - 1)]!, way[next]!];
    const share = to > from ? (at - from) / (to - from) : 0;
    return [[x + share * (u - x), y + share * (v - y)]];
  });
}

/** Has a line go through graphs, and a ring along paths, with the first drive, also while it is pulled or plays; `shown` is what the picture shows. */
export function follow(app: App, sheet: Sheet, shown: () => Curves | null): void {
  const mark = svgElement("path", { fill: "none", stroke: "var(--accent)", "aria-hidden": "true" });
  function place(): void {
    const drive = app.picture.value?.drives[0];
    const curves = shown();
    if (curves === null || drive === undefined) return mark.setAttribute("d", "");
    const rings = placesAt(curves.ways, drive).map(([x, y]) => `M${x - RING} ${y}a${RING} ${RING} 0 1 0 ${2 * RING} 0a${RING} ${RING} 0 1 0 ${-2 * RING} 0`);
    mark.setAttribute("d", (curves.axis === null ? "" : linesAt(curves.axis, drive)) + rings.join(""));
    mark.setAttribute("stroke-width", curves.axis === null ? "1" : "0.7");
  }
  sheet.drawn((picture) => {
    picture.append(mark);
    place();
  });
  app.picture.on(place);
}
