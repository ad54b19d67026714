import { fingers } from "../../../dom/fingers.ts";
import type { Pixel, Stage } from "./stage.ts";

/** A finger that stays so long, in ms, aims. */
const HOLD = 220;
/** A finger that goes farther than this, in pixels, does not tap. */
const STILL = 8;

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
  const down = fingers(root, view);
  /** Where the finger is. */
  let now: Pixel = [0, 0];
  let start: Pixel = [0, 0];
  /** From the finger to the place that it pulls. */
  let off: Pixel = [0, 0];
  let key: { name: string; isGuess: boolean; at: Pixel } | null = null;
  let doing: "nothing" | "press" | "aim" | "look" = "nothing";
  let clock = 0;

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

  function aim(): void {
    doing = "aim";
    clearTimeout(clock);
    hands.aimed(target(now));
  }
  function stop(): void {
    clearTimeout(clock);
    if (doing === "aim") hands.aimed(null);
    doing = "nothing";
  }

  root.addEventListener("pointerdown", (event) => {
    if (event.button > 0 || (event.target as Element).closest("button.aim") !== null) return;
    if (down.press(event) > 1) {
      stop();
      doing = "look";
      return;
    }
    start = now = down.at(event);
    off = [0, 0];
    key = (event.target as Element).closest("[data-key]") === null ? null : nearest(start);
    doing = "press";
    clock = window.setTimeout(aim, HOLD);
    if (!hands.isAsked()) take();
  });

  /** Takes hold of the mark under the hand. */
  function take(): void {
    if (key === null || key.isGuess) return;
    off = [key.at[0] - start[0], key.at[1] - start[1]];
    hands.held(key.name);
  }

  root.addEventListener("pointermove", (event) => {
    const before = down.move(event);
    if (before === null) return;
    now = down.at(event);
    if (doing === "press" && Math.hypot(now[0] - start[0], now[1] - start[1]) > STILL) {
      if (key !== null && !key.isGuess) {
        take();
        return aim();
      }
      stop();
      doing = "look";
      root.classList.add("panning");
    }
    if (doing === "aim") hands.aimed(target(now));
    else if (doing === "look") view.pan(now[0] - before[0], now[1] - before[1]);
  });

  const up = (event: PointerEvent): void => {
    if (down.lift(event) !== 0) return;
    root.classList.remove("panning");
    const was = doing;
    stop();
    if (event.type === "pointercancel") return;
    const at = down.at(event);
    // A mark that is only tapped is chosen, and stays.
    const isFree = key === null || (!key.isGuess && hands.isAsked());
    if (was === "aim") hands.placed(target(at), 0);
    else if (was === "press" && isFree) hands.placed(target(at), event.pointerType === "touch" ? MISSES.touch : MISSES.mouse);
    else if (was === "press" && key?.isGuess) hands.guessed(key.name);
  };
  root.addEventListener("pointerup", up);
  root.addEventListener("pointercancel", up);
  // The keys stay with the cross.
  root.addEventListener("mousedown", (event) => event.preventDefault());
  root.addEventListener("contextmenu", (event) => event.preventDefault());

  return {
    cancel() {
      const was = doing === "aim";
      stop();
      if (was) doing = "look";
      return was;
    },
  };
}
