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
  const fingers = new Map<number, Pixel>();
  let start: Pixel = [0, 0];
  /** From the finger to the place that it pulls. */
  let off: Pixel = [0, 0];
  let key: { name: string; isGuess: boolean } | null = null;
  let doing: "nothing" | "press" | "aim" | "look" = "nothing";
  let clock = 0;

  const inStage = ({ clientX, clientY }: { clientX: number; clientY: number }): Pixel => {
    const { left, top } = root.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  const target = (at: Pixel): Pixel => view.toSheet([at[0] + off[0], at[1] + off[1]]);

  function aim(): void {
    doing = "aim";
    clearTimeout(clock);
    hands.aimed(target([...fingers.values()][0] ?? start));
  }
  function stop(): void {
    clearTimeout(clock);
    if (doing === "aim") hands.aimed(null);
    doing = "nothing";
  }

  root.addEventListener("pointerdown", (event) => {
    if (event.button > 0 || (event.target as Element).closest("button.aim") !== null) return;
    fingers.set(event.pointerId, inStage(event));
    root.setPointerCapture(event.pointerId);
    if (fingers.size > 1) {
      stop();
      doing = "look";
      return;
    }
    start = inStage(event);
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
    const before = fingers.get(event.pointerId);
    if (before === undefined) return;
    const now = inStage(event);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    fingers.set(event.pointerId, now);
    if (other !== undefined) {
      const spread = (a: Pixel): number => Math.max(8, Math.hypot(a[0] - other[0], a[1] - other[1]));
      view.zoom(spread(now) / spread(before), other);
      // Two fingers that go together pan.
      view.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
      return;
    }
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
    if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
    root.classList.remove("panning");
    const was = doing;
    stop();
    if (event.type === "pointercancel") return;
    const at = inStage(event);
    // A mark that is only tapped is chosen, and stays.
    if (was === "aim" || (was === "press" && key === null)) hands.placed(target(at));
    else if (was === "press" && key?.isGuess) hands.guessed(key.name);
  };
  root.addEventListener("pointerup", up);
  root.addEventListener("pointercancel", up);
  // The keys stay with the cross.
  root.addEventListener("mousedown", (event) => event.preventDefault());
  root.addEventListener("contextmenu", (event) => event.preventDefault());

  root.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      if (event.shiftKey) return view.pan(-event.deltaY - event.deltaX, 0);
      const lines = event.deltaMode === 1 ? 16 : 1;
      view.zoom(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0016)), inStage(event));
    },
    { passive: false },
  );

  return {
    cancel() {
      const was = doing === "aim";
      stop();
      if (was) doing = "look";
      return was;
    },
  };
}
