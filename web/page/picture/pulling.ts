import type { Shown } from "../app.ts";
import { byId } from "../dom/find.ts";
import type { Grab } from "../engine/types.ts";
import { say } from "../layout/words.ts";
import { REST, type Gesture, type Gestures } from "./gesture.ts";
import type { Grip } from "./handles.ts";
import type { Viewport } from "../look/viewport.ts";

/** A place in the pane, in pixels from its corner. */
export function inPane(app: Shown, event: { clientX: number; clientY: number }): [number, number] {
  const pane = byId("pane", app.root);
  const { left, top, width } = pane.getBoundingClientRect();
  // Slides are shown larger or smaller than they are laid out.
  const scale = pane.clientWidth / width;
  return [(event.clientX - left) * scale, (event.clientY - top) * scale];
}

/** Pulls joints by mouse, pen and finger, and by arrow keys. */
export function pulling(app: Shown, view: Viewport, gestures: Gestures, bubble: { at(pixels: [number, number] | null): void }): (grip: Grip) => void {
  const what = (point: string): Grab =>
    app.shaping.value ? { kind: "shape", point, pins: app.pins.value } : { kind: "move", point };

  async function take(point: string): Promise<Gesture | null> {
    const gesture = await gestures.start(what(point));
    if (gesture === null && app.solved.value.refused !== null) app.tell(say("mend_first"));
    return gesture;
  }

  /** One pull: from the press to letting go. */
  function press(grip: Grip, event: PointerEvent): void {
    if (event.button !== 0 || event.ctrlKey) return;
    const { button, handle } = grip;
    event.preventDefault();
    event.stopPropagation();
    button.focus({ preventScroll: true });
    button.setPointerCapture(event.pointerId);
    button.classList.add("pulled");
    const start = inPane(app, event);
    const centre = view.toPane(handle.at);
    // Where it is taken hold of, it stays under the finger.
    const off: [number, number] = [centre[0] - start[0], centre[1] - start[1]];
    let last: [number, number] | null = null;
    let gesture: Gesture | null = null;
    const pull = (): void => {
      if (last !== null) gesture?.pull({ to: view.toSheet([last[0] + off[0], last[1] + off[1]]) });
    };
    bubble.at(start);
    const taken = take(handle.name).then((got) => {
      gesture = got;
      pull();
    });
    const listen = new AbortController();
    const on = <Name extends keyof HTMLElementEventMap>(name: Name, act: (event: HTMLElementEventMap[Name]) => void): void =>
      button.addEventListener(name, act, { signal: listen.signal });
    const finish = (how: "drop" | "cancel"): void => {
      listen.abort();
      button.classList.remove("pulled");
      bubble.at(null);
      void taken.then(() => gesture?.[how]());
      if (how === "cancel") app.speak(say("put_back"));
    };
    on("pointermove", (move) => {
      if (move.pointerId !== event.pointerId) return;
      last = inPane(app, move);
      bubble.at(last);
      pull();
    });
    on("pointerup", () => finish("drop"));
    on("pointercancel", () => finish("cancel"));
    on("keydown", (key) => {
      if (key.key !== "Escape") return;
      key.preventDefault();
      key.stopPropagation();
      finish("cancel");
    });
  }

  /** By keys: all presses until a rest are one gesture. */
  function keys(grip: Grip): void {
    let gesture: Gesture | null = null;
    let taking: Promise<void> | null = null;
    let clock = 0;
    let way: [number, number] = [0, 0];

    const finish = (how: "drop" | "cancel"): void => {
      clearTimeout(clock);
      const ended = gesture;
      gesture = null;
      taking = null;
      bubble.at(null);
      void ended?.[how]();
    };
    const pull = (): void => {
      const [x, y] = grip.handle.at;
      gesture?.pull({ to: [x + way[0], y + way[1]] });
      way = [0, 0];
    };
    grip.button.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && gesture !== null) {
        event.stopPropagation();
        finish("cancel");
        app.speak(say("put_back"));
        return;
      }
      const step = event.shiftKey ? 0.1 : 1;
      const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
      if (by === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      way = [way[0] + by[0]!, way[1] + by[1]!];
      clearTimeout(clock);
      clock = window.setTimeout(() => finish("drop"), REST);
      bubble.at(view.toPane(grip.handle.at));
      if (gesture !== null) pull();
      else
        taking ??= take(grip.handle.name).then((got) => {
          gesture = got;
          pull();
        });
    });
    grip.button.addEventListener("blur", () => gesture !== null && finish("drop"));
  }

  return (grip) => {
    grip.button.addEventListener("pointerdown", (event) => press(grip, event));
    keys(grip);
  };
}
