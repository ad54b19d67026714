import { byId } from "../dom/find.ts";
import { signal, type Signal } from "../state/signal.ts";
import { language } from "../words.ts";
import { name } from "./say.ts";
import { say } from "./words.ts";

/** How long the controls stay after the mouse has moved, in ms. */
const AWAKE = 2500;

/** Full screen, for a lesson: picture and caption; controls come while the mouse moves. */
export function fullScreen(): { on: Signal<boolean>; toggle(): void; leave(): boolean } {
  const on = signal(false);
  let clock = 0;
  on.on((is) => {
    document.body.classList.toggle("presenting", is);
    byId("full").setAttribute("aria-pressed", String(is));
  });
  const label = (): void => name(byId("full"), say(on.value ? "leave_full" : "full"));
  on.on(label);
  language.on(label);

  function set(is: boolean): void {
    on.set(is);
    wake();
    // Where the browser forbids it, the window is filled all the same.
    if (is) void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement !== null) void document.exitFullscreen().catch(() => undefined);
  }

  function wake(): void {
    clearTimeout(clock);
    document.body.classList.add("awake");
    clock = window.setTimeout(() => document.body.classList.remove("awake"), AWAKE);
  }

  document.addEventListener("fullscreenchange", () => document.fullscreenElement === null && on.value && on.set(false));
  document.addEventListener("pointermove", wake);
  document.addEventListener("pointerdown", wake);
  document.addEventListener("focusin", wake);
  const toggle = (): void => set(!on.value);
  byId("full").onclick = toggle;
  return {
    on,
    toggle,
    leave() {
      const was = on.value;
      if (was) set(false);
      return was;
    },
  };
}
