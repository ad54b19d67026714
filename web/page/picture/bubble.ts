import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { speak } from "../layout/messages.ts";
import { driveName } from "../motion/drives.ts";

/** What the drives stand at, beside the hand, and what stops them. */
export function bubble(app: App): { at(pixels: [number, number] | null): void } {
  const place = byId("bubble");
  const pane = byId("pane");
  let told = "";

  function write(): void {
    const picture = app.picture.value;
    if (place.hidden || picture === null) return;
    const values = picture.drives.map((drive) => `${driveName(drive)}: ${drive.shown}`);
    // That a panel is cut stands in the panel itself.
    const cut = picture.panels.filter(({ is_cut }) => is_cut);
    const stops = picture.notes.filter((note) => !cut.some(({ name }) => note.startsWith(`${name}:`)));
    const lines = app.shaping.value ? stops : [...values, ...stops];
    place.textContent = lines.join("\n");
    place.classList.toggle("empty", lines.length === 0);
    place.classList.toggle("stopped", stops.length > 0);
    const note = stops.join(" ");
    if (note !== told && note !== "") speak(note);
    told = note;
  }

  app.picture.on(write);
  return {
    at(pixels) {
      const wasHidden = place.hidden;
      place.hidden = pixels === null;
      if (pixels === null) {
        told = "";
        return;
      }
      if (wasHidden) write();
      const [x, y] = pixels;
      const isRight = x > pane.clientWidth / 2;
      place.style.transform = `translate(${x + (isRight ? -28 : 28)}px, ${Math.max(8, y - 60)}px) translateX(${isRight ? "-100%" : "0"})`;
    },
  };
}
