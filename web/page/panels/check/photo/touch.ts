import { fingers } from "../../../dom/fingers.ts";
import type { Pixel, Stage } from "./stage.ts";

/** A finger that stays so long, in ms, aims. */
const HOLD = 220;
/** A finger that goes farther than this, in pixels, does not tap. */
const STILL = 8;

/** What hands do on the photograph; places are in its pixels. */
export interface Hands {
  /** A finger goes down on a mark. */
  held(key: string): void;
  /** A guess is tapped. */
  guessed(key: string): void;
  /** Somebody aims, and the place under the finger; null as soon as nobody does. */
  aimed(at: Pixel | null): void;
  /** A place is chosen. */
  placed(at: Pixel): void;
}

/** Mouse, pen and fingers: tap, hold and aim, pull a mark, pan, pinch; and the wheel. */
export function touch({ root, view }: Stage, hands: Hands): { cancel(): boolean } {
  const down = fingers(root, view);
  /** Where the finger is. */
  let now: Pixel = [0, 0];
  let start: Pixel = [0, 0];
  /** From the finger to the place that it pulls. */
  let off: Pixel = [0, 0];
  let key: { name: string; isGuess: boolean } | null = null;
  let doing: "nothing" | "press" | "aim" | "look" = "nothing";
  let clock = 0;

  const target = (at: Pixel): Pixel => view.toSheet([at[0] + off[0], at[1] + off[1]]);

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
    const found = (event.target as Element).closest<SVGElement>("[data-key]");
    key = found === null ? null : { name: found.dataset["key"] ?? "", isGuess: found.classList.contains("guess") };
    if (key !== null && !key.isGuess) {
      const [x = 0, y = 0] = (/translate\(([-\d.e]+) ([-\d.e]+)\)/.exec(found?.getAttribute("transform") ?? "") ?? []).slice(1).map(Number);
      off = [x - start[0], y - start[1]];
    }
    doing = "press";
    clock = window.setTimeout(aim, HOLD);
    if (key !== null && !key.isGuess) hands.held(key.name);
  });

  root.addEventListener("pointermove", (event) => {
    const before = down.move(event);
    if (before === null) return;
    now = down.at(event);
    if (doing === "press" && Math.hypot(now[0] - start[0], now[1] - start[1]) > STILL) {
      if (key !== null && !key.isGuess) return aim();
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
    if (was === "aim" || (was === "press" && key === null)) hands.placed(target(at));
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
