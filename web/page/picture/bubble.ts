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
      // Beside the hand, on the side with more room, and never beyond the pane.
      const [x, y] = pixels;
      const { offsetWidth: width, offsetHeight: height } = place;
      const beside = x > pane.clientWidth / 2 ? x - 28 - width : x + 28;
      const within = (value: number, room: number): number => Math.max(8, Math.min(value, room - 8));
      place.style.transform = `translate(${within(beside, pane.clientWidth - width)}px, ${within(y - 60, pane.clientHeight - height)}px)`;
    },
  };
}
