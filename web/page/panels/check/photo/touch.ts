import { touch as touching } from "../../../look/touch.ts";
import type { Pixel, Stage } from "./stage.ts";

/** A finger that stays so long, in ms, aims. */
const HOLD = 220;

/** How far from where it is meant a tap is, in pixels, with 95 %: of a finger, and of a mouse or a pen. */
const MISSES = { touch: 22, mouse: 4 };

/** What hands do on the photograph; places are in its pixels. */
export interface Hands {
  /** Whether a point is asked for that has no place yet: it comes before the mark of another that is tapped. */
  isAsked(): boolean;
  /** A finger goes down on a mark. */
  held(key: string): void;
  /** A guess is tapped. */
  guessed(key: string): void;
  /** Somebody aims, and the place under the finger; null as soon as nobody does. */
  aimed(at: Pixel | null): void;
  /** A place is chosen, which the hand meets within so many pixels of the screen; 0 where it is seen magnified. */
  placed(at: Pixel, within: number): void;
}

/** Mouse, pen and fingers: tap, hold and aim, pull a mark, pan, pinch; and the wheel. */
export function touch({ root, view }: Stage, hands: Hands): { cancel(): boolean } {
  /** From the hand to the place that it pulls. */
  let off: Pixel = [0, 0];
  let key: { name: string; isGuess: boolean; at: Pixel } | null = null;

  const target = (at: Pixel): Pixel => view.toSheet([at[0] + off[0], at[1] + off[1]]);

  /** What stands nearest: where several lie over each other the last one would take every tap. */
  function nearest(at: Pixel): typeof key {
    const all = [...root.querySelectorAll<SVGElement>("[data-key]")].map((node) => {
      const [x = 0, y = 0] = (/translate\(([-\d.e]+) ([-\d.e]+)\)/.exec(node.getAttribute("transform") ?? "") ?? []).slice(1).map(Number);
      return { name: node.dataset["key"] ?? "", isGuess: node.classList.contains("guess"), at: [x, y] as Pixel };
    });
    const away = (one: { at: Pixel }): number => Math.hypot(one.at[0] - at[0], one.at[1] - at[1]);
    return all.sort((a, b) => away(a) - away(b))[0] ?? null;
  }

  /** Takes hold of the mark under the hand; whether there is one. */
  function take(start: Pixel): boolean {
    if (key === null || key.isGuess) return false;
    off = [key.at[0] - start[0], key.at[1] - start[1]];
    hands.held(key.name);
    return true;
  }

  const touched = touching(root, view, {
    takes: (event) => event.button === 0 && (event.target as Element).closest("button.aim") === null,
    pressed(press) {
      off = [0, 0];
      key = press.target.closest("[data-key]") === null ? null : nearest(press.start);
      if (!hands.isAsked()) take(press.start);
    },
    rests: {
      after: HOLD,
      pulls(_, at) {
        hands.aimed(target(at));
        return true;
      },
    },
    pulls: ({ start }) => take(start),
    pulled: (at) => hands.aimed(target(at)),
    dropped(at) {
      hands.aimed(null);
      hands.placed(target(at), 0);
    },
    cancelled: () => hands.aimed(null),
    tapped(at, { by }) {
      // A mark that is only tapped is chosen, and stays.
      const isFree = key === null || (!key.isGuess && hands.isAsked());
      if (isFree) hands.placed(target(at), by === "touch" ? MISSES.touch : MISSES.mouse);
      else if (key?.isGuess) hands.guessed(key.name);
    },
  });
  // The keys stay with the cross.
  root.addEventListener("mousedown", (event) => event.preventDefault());
  root.addEventListener("contextmenu", (event) => event.preventDefault());
  return touched;
}
