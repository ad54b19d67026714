import type { App } from "../../app.ts";
import { svgElement } from "../../dom/element.ts";
import type { Drive, DriveAxis } from "../../engine/types.ts";
import type { Sheet } from "../output/sheet.ts";

/** A turn in degrees. */
const TURN = 360;

/** The place of the drive's value in the graphs, from 0 at the left edge to 1 at the right; null where it is outside. */
function share({ low, high }: DriveAxis, { value, is_angle }: Drive): number | null {
  const turns = is_angle ? Math.ceil((low - value) / TURN) : 0;
  const part = (value + turns * TURN - low) / (high - low);
  return part >= 0 && part <= 1 ? part : null;
}

/** Lets a line go through the graphs with the first drive, also while it is pulled or plays; `axis` is that of the picture shown. */
export function follow(app: App, sheet: Sheet, axis: () => DriveAxis | null): void {
  const line = svgElement("path", { stroke: "var(--accent)", "stroke-width": "0.7", "aria-hidden": "true" });
  function place(): void {
    const drive = app.picture.value?.drives[0];
    const graphs = axis();
    const at = graphs === null || drive === undefined ? null : share(graphs, drive);
    const lines = at === null ? [] : (graphs?.areas ?? []).map(([x, y, width, height]) => `M${x + at * width} ${y}v${height}`);
    line.setAttribute("d", lines.join(""));
  }
  sheet.drawn((picture) => {
    picture.append(line);
    place();
  });
  app.picture.on(place);
}
