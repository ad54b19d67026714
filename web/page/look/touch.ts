import { fingers, type Pixels } from "./fingers.ts";
import type { Viewport } from "./viewport.ts";

/** How far a press may wander and still be a tap, in pixels: of a finger, and of a mouse or a pen. */
const STILL = { touch: 8, other: 5 };

/** One press of a mouse, a pen or a finger. */
export interface Press {
  /** Where it began, in pixels from the corner of what is looked at. */
  readonly start: Pixels;
  readonly by: "mouse" | "pen" | "touch";
  readonly target: Element;
  readonly button: number;
  readonly shift: boolean;
}

/** What hands do on something that is looked at; what is left out does nothing. Two fingers always zoom and pan, and end what one has begun. */
export interface Hands {
  /** Whether a press counts; without it all with the first button do. */
  takes?(event: PointerEvent): boolean;
  pressed?(press: Press): void;
  /** A press rests for so many ms: whether it pulls from here on. */
  rests?: { readonly after: number; pulls(press: Press, at: Pixels): boolean };
  /** A press goes off: whether it pulls; else it pans. */
  pulls?(press: Press): boolean;
  pulled?(at: Pixels, press: Press): void;
  /** What was pulled is let go. */
  dropped?(at: Pixels, press: Press): void;
  /** What was pulled goes on no longer, and is not let go. */
  cancelled?(): void;
  tapped?(at: Pixels, press: Press, time: number): void;
  /** Whether one finger, or the mouse, pans just now; without it always. */
  pans?(): boolean;
  /** A press that has not pulled ends elsewhere. */
  swept?(way: Pixels, press: Press): void;
}

/** Mouse, pen and fingers: tap, rest, pull, pan, pinch; and the wheel. `cancel` ends what is pulled, and says whether something was. */
export function touch(root: HTMLElement | SVGSVGElement, view: Pick<Viewport, "zoom" | "pan">, hands: Hands): { cancel(): boolean } {
  const down = fingers(root, view);
  let press: Press | null = null;
  let now: Pixels = [0, 0];
  let doing: "nothing" | "press" | "pull" | "look" = "nothing";
  let clock = 0;

  function become(next: typeof doing): void {
    clearTimeout(clock);
    if (doing === "pull" && next !== "pull") hands.cancelled?.();
    doing = next;
    root.classList.toggle("panning", next === "look" && hands.pans?.() !== false);
  }

  const onDown = (event: PointerEvent): void => {
    if (!(hands.takes?.(event) ?? event.button === 0)) return;
    if (down.press(event) > 1) return become("look");
    now = down.at(event);
    press = { start: now, by: event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse", target: event.target as Element, button: event.button, shift: event.shiftKey };
    become("press");
    const { rests } = hands;
    const begun = press;
    if (rests !== undefined) clock = window.setTimeout(() => rests.pulls(begun, now) && become("pull"), rests.after);
    hands.pressed?.(press);
  };

  const onMove = (event: PointerEvent): void => {
    const before = down.move(event);
    if (before === null || press === null) return;
    now = down.at(event);
    const way = Math.hypot(now[0] - press.start[0], now[1] - press.start[1]);
    if (doing === "press" && way > (press.by === "touch" ? STILL.touch : STILL.other)) become(hands.pulls?.(press) === true ? "pull" : "look");
    if (doing === "pull") hands.pulled?.(now, press);
    else if (doing === "look" && hands.pans?.() !== false) view.pan(now[0] - before[0], now[1] - before[1]);
  };

  const onUp = (event: PointerEvent): void => {
    if (down.lift(event) !== 0 || press === null) return;
    const [was, of, at] = [doing, press, down.at(event)];
    const isLost = event.type === "pointercancel";
    if (was === "pull" && !isLost) doing = "nothing";
    become("nothing");
    press = null;
    if (isLost) return;
    if (was === "pull") hands.dropped?.(at, of);
    else if (was === "press") hands.tapped?.(at, of, event.timeStamp);
    else if (was === "look") hands.swept?.([at[0] - of.start[0], at[1] - of.start[1]], of);
  };

  const listens = root as HTMLElement;
  listens.addEventListener("pointerdown", onDown);
  listens.addEventListener("pointermove", onMove);
  listens.addEventListener("pointerup", onUp);
  listens.addEventListener("pointercancel", onUp);
  return {
    cancel() {
      const was = doing === "pull";
      if (was) become("look");
      return was;
    },
  };
}
