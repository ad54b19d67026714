import type { App } from "../app.ts";
import { byId, takesText } from "../dom/find.ts";
import { SHEETS } from "../engine/types.ts";
import type { Drives } from "../motion/drives.ts";
import type { Play } from "../motion/play.ts";
import { choose } from "../picture/focus.ts";
import type { Store } from "../state/storage.ts";
import type { Steps } from "../steps/steps.ts";
import { speak } from "./messages.ts";
import { say } from "./words.ts";

/** What the keys need. */
export interface KeyParts {
  steps: Steps;
  drives: Drives;
  play: Play;
  full: { toggle(): void; leave(): boolean };
  store: Store;
}

/** Undo and redo; said aloud. */
export function undo(app: App): void {
  if (!app.history.canUndo.value) return;
  app.history.undo();
  speak(say("undone"));
}
export function redo(app: App): void {
  if (!app.history.canRedo.value) return;
  app.history.redo();
  speak(say("redone"));
}

/** Keys of the whole page. Controls that use a key themselves stop it on its way up. */
export function keys(app: App, { steps, drives, play, full, store }: KeyParts): void {
  const press = (id: string): void => byId(id).click();
  const always: Record<string, (event: KeyboardEvent) => void> = {
    ArrowRight: () => steps.by(1),
    ArrowLeft: () => steps.by(-1),
    PageDown: () => steps.by(1),
    PageUp: () => steps.by(-1),
    Home: () => steps.go(1),
    End: () => steps.go(Infinity),
    ArrowUp: (event) => drives.nudge(event.shiftKey ? 0.1 : 1),
    ArrowDown: (event) => drives.nudge(event.shiftKey ? -0.1 : -1),
  };
  const letters: Record<string, () => void> = {
    "?": () => press("help-button"),
    "0": () => press("fit"),
    f: () => press("fit"),
    "+": () => press("zoom-in"),
    "=": () => press("zoom-in"),
    "-": () => press("zoom-out"),
    ...Object.fromEntries(SHEETS.map(({ key }, index) => [String(index + 1), () => choose(key)])),
    a: () => choose(""),
    m: () => press("hand-move"),
    s: () => press("hand-shape"),
    b: () => press("hand-build"),
    d: () => press("dark"),
    p: () => full.toggle(),
  };

  document.addEventListener("keydown", (event) => {
    const { key, target } = event;
    if (event.defaultPrevented) return;
    if (event.ctrlKey || event.metaKey) {
      // In a box of text the browser's own undo works.
      if (event.altKey || takesText(target)) return;
      const act = { z: event.shiftKey ? redo : undo, y: redo }[key.toLowerCase()];
      if (act !== undefined) {
        event.preventDefault();
        act(app);
      }
      return;
    }
    // Out of a panel, to its tab, or back to the stage of Build; in the editor Escape has a meaning of its own.
    if (key === "Escape" && target instanceof Element && target.closest("#panels") !== null && target.closest(".cm-editor, dialog:modal, [type=search]:not(:placeholder-shown)") === null)
      return document.querySelector<HTMLElement>(app.building.value ? "#build-stage" : "#tabs [aria-selected=true]")?.focus();
    if (event.altKey || takesText(target) || document.querySelector("dialog:modal") !== null) return;
    const control = target instanceof Element ? target.closest("button, a, summary, input, [role=radio], [role=tab], [role=option], [role=slider]") : null;
    // In a panel arrows move its own things and scroll it.
    const inPanel = target instanceof Element && target.closest("#panels, [popover]:popover-open") !== null;
    if (key === "Escape") return void full.leave();
    if (key === " " && control === null && !inPanel && !app.building.value) {
      event.preventDefault();
      return play.toggle();
    }
    const isRange = target instanceof HTMLInputElement;
    if (key in always && !isRange && !inPanel && !app.building.value) {
      event.preventDefault();
      return always[key]?.(event);
    }
    if (store.preference("letters") === "no" || inPanel) return;
    const act = letters[key.toLowerCase()];
    if (act === undefined) return;
    event.preventDefault();
    act();
  });
}
