import type { App } from "../app.ts";

/** The panel that a student has; the others show answers, or change the scene that the sheet is about. */
export const STUDENTS_PANEL = "check";

/** By a student's link the scheme alone is shown, and nothing moves, until the student wants to see the plans. */
export function studying(app: App): void {
  app.student.on((is) => {
    document.body.classList.toggle("student", is);
    const { panels, ...view } = app.view.value;
    if (is) app.view.set({ ...view, step: null, panels: ["scheme"] });
    else if (panels !== undefined) app.view.set(view);
  });
  // A second student's link in the same tab brings a view of its own.
  app.view.on((view) => app.student.value && view.panels === undefined && app.view.set({ ...view, step: null, panels: ["scheme"] }));
}
