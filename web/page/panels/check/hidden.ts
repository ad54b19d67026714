import type { App } from "../../app.ts";

/** Hides the answers of a student's link until they are asked for: the picture shows the scheme alone, other panels are away. */
export function hideAnswers(app: App): void {
  app.student.on((is) => {
    document.documentElement.dataset["student"] = is ? "yes" : "no";
    const { panels: _, ...view } = app.view.value;
    if (is) {
      app.view.set({ ...view, step: null, panels: ["scheme"] });
      app.show("check");
    } else if (app.view.value.panels != null) app.view.set(view);
  });
  // A view that somebody else sets keeps the secret.
  app.view.on((view) => {
    if (app.student.value && (view.panels == null || view.step !== null || view.modes)) app.view.set({ ...view, step: null, modes: false, panels: ["scheme"] });
  });
}
