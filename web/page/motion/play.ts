import type { Shown } from "../app.ts";
import { byId } from "../dom/find.ts";
import { icon } from "../dom/icon.ts";
import { name } from "../layout/say.ts";
import { say } from "../layout/words.ts";
import type { Gesture, Gestures } from "../picture/gesture.ts";
import { orTell } from "../refused.ts";
import { signal, type Signal } from "../state/signal.ts";
import { language } from "../words.ts";
import { courseOf, following, type Course } from "./course.ts";
import type { Drives } from "./drives.ts";

/** One turn, or once from end to end, takes so many seconds at normal speed. */
export const SECONDS = 6;
/** With reduced motion the drive goes in steps: so many a second. */
const CALM = 2;

/** Lets the drives run, round or to and fro between their limits. */
export interface Play {
  readonly on: Signal<boolean>;
  toggle(): void;
  stop(): void;
}

export function play(app: Shown, gestures: Gestures, drives: () => Drives): Play {
  const on = signal(false);
  const button = byId("play", app.root);
  const speed = byId<HTMLSelectElement>("speed", app.root);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  let gesture: Gesture | null = null;
  /** Counts starts and stops: what a start has waited for may be wanted no more. */
  let attempt = 0;
  let hasTold = false;

  async function start(): Promise<void> {
    const own = (attempt += 1);
    const isWanted = (): boolean => on.value && own === attempt;
    on.set(true);
    await gestures.end();
    const course = isWanted() ? await courseOf(app, drives().current()) : null;
    const held = course !== null && isWanted() ? await gestures.start(course.what) : null;
    if (!isWanted()) return held?.drop();
    if (course === null || held === null) return on.set(false);
    gesture = held;
    if (course.isTogether && !hasTold) app.tell(say("together"));
    hasTold ||= course.isTogether;
    run(held, course);
  }

  function run(held: Gesture, { drive, from, low, high, isRound, sense }: Course): void {
    const follows = following(app, drive);
    let value = from;
    let way: number = sense;
    let turnedAt: number | null = null;
    let before: number | null = null;
    let shown = 0;
    /** Turns round where something stops the drive sooner than was known; false where it can go neither way. */
    function turned(): boolean {
      const at = follows.at();
      if (at === turnedAt) return false;
      [value, way, turnedAt] = [at, -way, at];
      follows.again();
      return true;
    }
    const tick = (now: number): void => {
      if (gesture !== held) return follows.end();
      if (!held.isHeld() || (follows.isStuck() && !turned())) {
        follows.end();
        if (held.isHeld()) app.tell(say("stuck"));
        return stop();
      }
      const passed = before === null ? 0 : Math.min((now - before) / 1000, 0.1);
      before = now;
      value += (way * passed * (high - low) * Number(speed.value)) / SECONDS;
      if (!isRound && (value >= high || value <= low)) {
        way = value >= high ? -1 : 1;
        value = Math.min(Math.max(value, low), high);
      }
      if (!calm.matches || now - shown > 1000 / CALM) {
        shown = now;
        held.pull({ value });
      }
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  function stop(): void {
    if (!on.value) return;
    attempt += 1;
    on.set(false);
    void gesture?.drop();
    gesture = null;
  }

  const show = (): void => {
    const several = (app.solved.value.opened?.drives.length ?? 0) > 1;
    button.replaceChildren(icon(on.value ? "pause" : "play"));
    button.setAttribute("aria-pressed", String(on.value));
    name(button, say(on.value ? "pause" : several ? "play_together" : "play"));
  };
  on.on(show);
  app.solved.on(show);
  language.on(show);
  // Nothing moves behind what is being built.
  app.building.on((is) => is && stop());
  const toggle = (): void => {
    if (on.value) return stop();
    void orTell(app, () =>
      start().catch((why: unknown) => {
        stop();
        throw why;
      }),
    );
  };
  button.onclick = toggle;
  return { on, toggle, stop };
}
