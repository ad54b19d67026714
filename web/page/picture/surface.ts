import type { App } from "../app.ts";
import type { Pane, View } from "../engine/types.ts";
import { byId } from "../dom/find.ts";
import { signal, type Signal } from "../state/signal.ts";
import type { Viewport } from "../look/viewport.ts";

/** Smallest and largest letters, in pixels, and their part of the mean side of the pane; in full screen they are for the last row: so much of its height. */
const [LEAST, MOST, PART, LESSON] = [12, 18, 0.021, 0.032];

/** White below the buttons, in pixels. */
const BELOW_BUTTONS = 6;

/** Below this width or height the words of a step stand beside the sheet, in lines that fit. */
const [ROOMY_WIDTH, ROOMY_HEIGHT] = [620, 400];

/** The part of the screen for which a drawing is laid out, with letters that are read there. */
export function paneOf(width: number, height: number, isLesson = false): Pane {
  const mean = Math.sqrt(width * height);
  const letters = isLesson ? Math.max(LEAST, LESSON * height) : Math.min(Math.max(PART * mean, LEAST), MOST);
  return { width, height, letters, words: width >= ROOMY_WIDTH && height >= ROOMY_HEIGHT };
}

/**
 * What the picture is laid out for: the document's view on the part of the screen that the pane has, or on its paper. While the
 * pane is without a size there is nothing to be seen.
 */
export function surface(app: App, view: Viewport, lesson: Signal<boolean>): Signal<View> {
  const sight = signal<View>(app.view.value);
  function look(): void {
    // While a sheet is read the picture waits.
    if (document.body.classList.contains("reading")) return;
    const { width, height } = view.room();
    const pane = paneOf(width, height, lesson.value);
    // The words of a step are on the sheet, and the page need not repeat them.
    document.body.classList.toggle("worded", pane.words);
    byId("pane").classList.toggle("on-paper", app.paper.value);
    const focus = app.focus.value;
    const trace = app.traced.value;
    // On paper it is the file that is saved, and no more.
    const onScreen = { pane, ...(focus === "" ? {} : { focus }), ...(trace.length === 0 ? {} : { trace }) };
    const next: View = { ...app.view.value, ...(app.paper.value ? {} : onScreen) };
    sight.set(next);
  }
  app.view.on(look);
  app.paper.on(look);
  app.focus.on(look);
  app.traced.on(look);
  // Buttons stand above the picture; in full screen they come and go over it.
  const buttons = byId("look");
  const keepFree = (): void => view.keepFree(lesson.value ? null : buttons.offsetTop + buttons.offsetHeight + BELOW_BUTTONS);
  lesson.on(keepFree);
  new ResizeObserver(keepFree).observe(buttons);
  view.resized.on(look);
  return sight;
}
