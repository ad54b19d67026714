import { byId } from "../dom/find.ts";
import type { Store } from "../state/storage.ts";

/** Narrowest and widest panel, in pixels. */
const [LEAST, MOST] = [300, 900];

/** The bar between picture and panels, by mouse and by arrow keys. */
export function splitter(store: Store): void {
  const bar = byId("splitter");
  let width = Number(store.preference("width") ?? 400);

  function set(next: number): void {
    width = Math.min(Math.max(next, LEAST), Math.max(LEAST, Math.min(MOST, window.innerWidth - 480)));
    document.documentElement.style.setProperty("--side", `${width}px`);
    for (const [name, value] of [["now", width], ["min", LEAST], ["max", MOST]]) bar.setAttribute(`aria-value${name}`, String(Math.round(Number(value))));
  }

  bar.onpointerdown = (event) => {
    bar.setPointerCapture(event.pointerId);
    const start = event.clientX + width;
    bar.onpointermove = (move) => set(start - move.clientX);
    bar.onpointerup = bar.onpointercancel = () => {
      bar.onpointermove = null;
      store.prefer("width", String(width));
    };
  };
  bar.onkeydown = (event) => {
    const by = { ArrowLeft: 20, ArrowRight: -20 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(width + by);
    store.prefer("width", String(width));
  };
  window.addEventListener("resize", () => set(width));
  set(width);
}
