import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { signal } from "../state/signal.ts";
import type { Viewport } from "./viewport.ts";

/** Marks places on the picture for a panel: by pressing there, or with cross-hairs that arrow keys move. */
export function picking(app: App, view: Viewport): { pick: App["pick"]; tapped(pixels: [number, number]): boolean } {
  const wanted = signal<((at: [number, number]) => void) | null>(null);
  const hairs = byId("crosshairs");
  const layer = byId("markers");
  let cursor: [number, number] = [0, 0];

  function place(): void {
    const [x, y] = view.toPane(cursor);
    hairs.style.transform = `translate(${x}px, ${y}px)`;
    layer.replaceChildren(
      ...app.markers.value.map(({ at, label }) => {
        const [left, top] = view.toPane(at);
        const mark = element("span", { class: "marker" }, element("b", {}, label));
        mark.style.transform = `translate(${left}px, ${top}px)`;
        return mark;
      }),
    );
  }
  view.now.on(place);
  app.markers.on(place);

  wanted.on((picked) => {
    hairs.hidden = picked === null;
    byId("pane").classList.toggle("picking", picked !== null);
    byId("handles").hidden = picked !== null;
    if (picked === null) return;
    cursor = view.toSheet([view.size.width / 2, view.size.height / 2]);
    place();
  });

  hairs.onclick = (event) => {
    // By the keyboard; a mouse presses through it.
    if (event.detail === 0) wanted.value?.(cursor);
  };
  hairs.onkeydown = (event) => {
    const step = event.shiftKey ? 0.1 : 1;
    const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    cursor = [cursor[0] + by[0]!, cursor[1] + by[1]!];
    place();
  };

  return {
    pick(picked) {
      wanted.set(picked);
      return () => {
        if (wanted.value === picked) wanted.set(null);
      };
    },
    tapped(pixels) {
      if (wanted.value === null) return false;
      cursor = view.toSheet(pixels);
      place();
      wanted.value(cursor);
      return true;
    },
  };
}
