import type { App } from "../app.ts";
import { thisPage } from "./lesson.ts";
import type { Kept, Store } from "./storage.ts";

/** The document as it is kept. */
export function asKept(app: App): Kept {
  const title = app.solved.value.opened?.title ?? "";
  const asked = app.course === null ? {} : { asked: app.asked };
  return { ...app.history.now.value, title, student: app.student.value, task: app.task.value, board: app.board.value, ...asked, page: thisPage(), time: Date.now() };
}

/** Keeps the document a moment after each change, and at once when the page is left. */
export function autosave(app: App, store: Store): void {
  let clock = 0;
  let kept = app.history.now.value;
  const keep = (): void => {
    clearTimeout(clock);
    const now = app.history.now.value;
    if (now === kept) return;
    kept = now;
    store.keep(asKept(app), app.history.past());
  };
  app.history.now.on(() => {
    clearTimeout(clock);
    clock = window.setTimeout(keep, 400);
  });
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && keep());
  window.addEventListener("pagehide", keep);
}
