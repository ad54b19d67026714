import { element } from "../../../dom/element.ts";
import { keyOf } from "./placing.ts";
import { plain } from "./points_bar.ts";
import type { Item, Session } from "./session.ts";
import type { Pixel, Stage } from "./stage.ts";
import { say } from "./words.ts";

/** How far arrow keys go, in mm; with Shift. */
const [STEP, LARGE] = [0.1, 1];

/** What keys do. */
export interface Keys {
  /** Marks the chosen point at a place of the photograph. */
  place(at: Pixel): void;
  /** Goes on to the next point. */
  next(): void;
  /** A point that is marked goes to a place in mm from the pole. */
  moved(one: Item, at: Pixel): void;
  left(): void;
}

/** The cross that keys move: on the chosen point, or where it is to be marked. */
export function aiming({ view }: Stage, session: () => Session | null, keys: Keys): { root: HTMLButtonElement; show(): void; middle(): void } {
  const root = element("button", { type: "button", class: "aim", hidden: true });
  /** Where somebody aims, in the photograph. */
  let cursor: Pixel = [0, 0];
  const chosen = (): Item | undefined => {
    const own = session();
    return own?.item(own.chosen);
  };

  function show(): void {
    const own = session();
    const one = chosen();
    root.hidden = one === undefined;
    if (own === null || one === undefined) return;
    root.setAttribute("aria-label", say("aim", { name: plain(one.label) }));
    const mark = own.marks.find(({ plan, name }) => keyOf(plan, name) === one.key);
    const pole = one.isPole ? one.plan.points[0]?.at : undefined;
    const [x, y] = view.toPane((mark?.pixel ?? pole ?? cursor) as Pixel);
    root.style.transform = `translate(${x}px, ${y}px)`;
  }
  view.now.on(show);

  root.onkeydown = (event) => {
    const own = session();
    const one = chosen();
    if (own === null || one === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const at = own.placeOf(one) ?? (one.isPole ? [0, 0] : undefined);
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] as Pixel | undefined;
    if (way !== undefined) {
      const step = event.shiftKey ? LARGE : STEP;
      if (at === undefined) {
        cursor = [cursor[0] + way[0] * step * own.photo.per_mm, cursor[1] - way[1] * step * own.photo.per_mm];
        show();
      } else keys.moved(one, [at[0] + way[0] * step, at[1] + way[1] * step].map((mm) => Math.round(100 * mm) / 100) as Pixel);
    } else if (event.key === "Enter" || event.key === " ") {
      if (at === undefined) keys.place(cursor);
      else keys.next();
    } else return;
    event.preventDefault();
  };
  root.onblur = () => keys.left();
  // The ring is for those who use keys; a finger has its own sign.
  document.addEventListener("keydown", () => root.classList.add("keyed"), true);
  document.addEventListener("pointerdown", () => root.classList.remove("keyed"), true);

  return {
    root,
    show,
    middle() {
      cursor = view.toSheet([view.size.width / 2, view.size.height / 2]);
      show();
    },
  };
}
