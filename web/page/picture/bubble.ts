import type { App } from "../app.ts";
import { byId } from "../dom.ts";
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
    const notes = app.shaping.value ? picture.notes : [...values, ...picture.notes];
    place.textContent = notes.join("\n");
    place.classList.toggle("stopped", picture.notes.length > 0);
    const note = picture.notes.join(" ");
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
