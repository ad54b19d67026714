import type { App } from "../app.ts";
import { byId } from "../dom/find.ts";
import { icon } from "../dom/icon.ts";
import { name } from "../layout/say.ts";
import { say } from "../layout/words.ts";
import type { Gesture, Gestures } from "../picture/gesture.ts";
import { signal, type Signal } from "../state/signal.ts";
import { language } from "../words.ts";
import { range, type Drives } from "./drives.ts";

/** One turn, or once from end to end, takes so many seconds at normal speed. */
const SECONDS = 6;
/** With reduced motion the drive goes in steps: so many a second. */
const CALM = 2;

/** Lets the drive go round, or to and fro between its limits. */
export interface Play {
  readonly on: Signal<boolean>;
  toggle(): void;
  stop(): void;
}

export function play(app: App, gestures: Gestures, drives: () => Drives): Play {
  const on = signal(false);
  const button = byId("play");
  const speed = byId<HTMLSelectElement>("speed");
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  let gesture: Gesture | null = null;

  async function start(): Promise<void> {
    const drive = drives().current();
    if (drive === undefined || app.solved.value.refused !== null) return;
    on.set(true);
    const held = await gestures.start({ kind: "drive", drive: drive.name });
    if (held === null || !on.value) return on.set(false);
    gesture = held;
    const [low, high] = range(drive);
    const isRound = drive.low === null || drive.high === null;
    let value = drive.value;
    let way = 1;
    let before: number | null = null;
    let shown = 0;
    const tick = (now: number): void => {
      if (!on.value || gesture !== held) return;
      if (!gestures.isActive()) return on.set(false);
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
    on.set(false);
    void gesture?.drop();
    gesture = null;
  }

  const show = (): void => {
    button.replaceChildren(icon(on.value ? "pause" : "play"));
    button.setAttribute("aria-pressed", String(on.value));
    name(button, say(on.value ? "pause" : "play"));
  };
  on.on(show);
  language.on(show);
  const toggle = (): void => (on.value ? stop() : void start());
  button.onclick = toggle;
  return { on, toggle, stop };
}
