import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { choose, type Focus } from "./focus.ts";
import { touch } from "../look/touch.ts";
import type { Viewport } from "../look/viewport.ts";

/** Two taps closer than this, in ms and pixels, are one double tap. */
const DOUBLE = { time: 320, way: 24 };
/** A finger that goes farther than this swipes. */
const SWIPE = 48;
/** A pane narrower than this is that of a telephone, and letters smaller than that are not read there; in pixels. */
const [NARROW, LETTERS] = [600, 11.5];

/** Zooms and pans: wheel, pinch, dragging the ground, double taps, buttons. */
export function looking(app: App, view: Viewport, focus: Focus): void {
  const pane = byId("pane");
  let lastTap = { time: 0, at: [0, 0] as [number, number] };

  const middle = (): [number, number] => [view.size.width / 2, view.size.height / 2];
  byId("zoom-in").onclick = () => view.zoom(1.25, middle());
  byId("zoom-out").onclick = () => view.zoom(0.8, middle());
  byId("fit").onclick = () => view.refit();

  // A sheet in place of the picture is there to be read: on a telephone it begins at its upper left corner, unless it is to be seen whole.
  const read = (): void => {
    const picture = app.picture.value;
    if (picture === null || picture.panels.length > 0 || view.size.width >= NARROW || document.body.classList.contains("whole")) return;
    view.refit();
    const letters = Math.min(...[...picture.svg.matchAll(/<text[^>]* font-size="([\d.]+)"/g)].map(([, size]) => Number(size)));
    const factor = LETTERS / (letters * view.now.value.scale);
    if (factor <= 1 || !Number.isFinite(factor)) return;
    const corner = view.toPane([0, 0]);
    view.zoom(factor, corner);
    view.pan(0, view.size.height - view.room().height - corner[1]);
  };
  app.picture.on(read);
  view.resized.on(read);

  touch(pane, view, {
    takes: (event) => event.button <= 1 && (event.target as Element).closest(".floating, .handle") === null,
    pans: () => view.isZoomed(),
    tapped: (at, _, time) => tap(at, time),
    swept: ([way], { by }) => by === "touch" && !view.isZoomed() && Math.abs(way) > SWIPE && focus.swipe(way < 0 ? 1 : -1),
  });

  function tap(at: [number, number], time: number): void {
    const isDouble = time - lastTap.time < DOUBLE.time && Math.hypot(at[0] - lastTap.at[0], at[1] - lastTap.at[1]) < DOUBLE.way;
    lastTap = { time: isDouble ? 0 : time, at };
    if (!isDouble) return;
    if (view.isZoomed()) view.refit();
    else choose(app.focus.value === "" ? focus.at(view.toSheet(at)) : "");
  }
}
