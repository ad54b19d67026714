import type { Shown } from "../app.ts";
import { byId } from "../dom/find.ts";
import { driveName } from "../motion/drives.ts";

/** How far it is from the hand, from the edge of the pane, and from what is held, in pixels. */
const [AWAY, EDGE, CLEAR] = [34, 8, 16];

/** What the drives stand at, beside the hand, and what stops them. */
export function bubble(app: Shown): { at(pixels: [number, number] | null): void } {
  const place = byId("bubble", app.root);
  const pane = byId("pane", app.root);
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
    if (note !== told && note !== "") app.speak(note);
    told = note;
  }

  /** A place beside the hand within the pane that covers neither the hand nor the joint, which stays behind where something stops it. */
  function besides([x, y]: [number, number], [width, height]: [number, number]): [number, number] {
    const [wide, high] = [pane.clientWidth - width - EDGE, pane.clientHeight - height - EDGE];
    const within = (value: number, most: number): number => Math.max(EDGE, Math.min(value, most));
    const [right, left, level] = [x + AWAY, x - AWAY - width, y - height / 2];
    const sides: [number, number][] = [[right, level], [left, level], [x - width / 2, y - AWAY - height], [x - width / 2, y + AWAY]];
    // That with more room first.
    if (x > pane.clientWidth / 2) [sides[0], sides[1]] = [sides[1]!, sides[0]!];
    const { left: paneLeft, top: paneTop } = pane.getBoundingClientRect();
    const joint = app.root.querySelector(".handle.pulled, .handle:focus-visible")?.getBoundingClientRect();
    const held: [number, number][] = [[x, y]];
    if (joint !== undefined) held.push([joint.left + joint.width / 2 - paneLeft, joint.top + joint.height / 2 - paneTop]);
    const covered = ([left, top]: [number, number]): number =>
      held.filter(([x, y]) => x > left - CLEAR && x < left + width + CLEAR && y > top - CLEAR && y < top + height + CLEAR).length;
    const placed = sides.map(([left, top]): [number, number] => [within(left, wide), within(top, high)]);
    return placed.reduce((best, next) => (covered(next) < covered(best) ? next : best));
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
      const { offsetWidth: width, offsetHeight: height } = place;
      const [left, top] = besides(pixels, [width, height]);
      place.style.transform = `translate(${left}px, ${top}px)`;
    },
  };
}
