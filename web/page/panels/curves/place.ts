import type { App } from "../../app.ts";
import { byId } from "../../dom/find.ts";
import type { Pane } from "../../engine/types.ts";
import { paneOf } from "../../picture/surface.ts";
import { signal, type Signal } from "../../state/signal.ts";

/** Height of the drawing over its width, where it stands in the panel. */
const SLENDER = 0.8;

/** Has the drawing of a panel below the moving picture where there is room, else in the panel; the answer is the part of the screen that it has there. */
export function place(app: App, panel: string, room: HTMLElement, drawing: HTMLElement): Signal<Pane> {
  const below = byId("below");
  const pane = signal<Pane>(paneOf(400, 300));
  const roomy = window.matchMedia("(min-width: 960px) and (min-height: 560px)");
  function measure(): void {
    const { clientWidth: width, clientHeight: height } = drawing.parentElement ?? room;
    if (width > 0) pane.set(paneOf(width, roomy.matches ? height : SLENDER * width));
  }
  function settle(): void {
    (roomy.matches ? below : room).append(drawing);
    below.hidden = !roomy.matches || app.shown.value !== panel || app.solved.value.opened?.is_drawn === true;
    measure();
  }
  roomy.addEventListener("change", settle);
  app.shown.on(settle);
  app.solved.on(settle);
  const size = new ResizeObserver(measure);
  size.observe(below);
  size.observe(room);
  return pane;
}
