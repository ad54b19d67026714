import { byId } from "../dom/find.ts";
import type { Signal } from "../state/signal.ts";
import { say } from "./words.ts";

/** How long somebody waits before they may want to stop, in ms: what is over sooner needs no button that comes and goes. */
const PATIENT = 700;
/** Work that goes on after so short a pause, in ms, is the same. */
const BREATH = 300;

/** Tells that the engine works, and lets people stop it: the page does not wait for it, and the scene stays what it is. */
export function working(busy: Signal<boolean>, stop: () => void): void {
  const button = byId<HTMLButtonElement>("stop");
  let clock = 0;
  let begin: number | null = null;
  busy.on((is) => {
    byId("busy").textContent = is ? say("busy") : "";
    clearTimeout(clock);
    if (is) begin ??= performance.now();
    const [wait, hidden] = is ? [PATIENT + begin! - performance.now(), false] : [BREATH, true];
    clock = window.setTimeout(() => {
      button.hidden = hidden;
      if (hidden) begin = null;
    }, Math.max(0, wait));
  });
  button.onclick = stop;
}
