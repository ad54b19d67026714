import type { Shown } from "../app.ts";
import type { Opened, Step } from "../engine/types.ts";
import { signal, type Signal } from "../state/signal.ts";

/** Going through the construction: from its first step to the finished figure, which is after the last one. */
export interface Steps {
  /** Whether the steps' bar is shown. */
  readonly on: Signal<boolean>;
  count(): number;
  /** The present step; one more than there are for the finished figure. */
  now(): number;
  /** What is said at the present step; null at the finished figure. */
  said(): Said | null;
  go(step: number): void;
  by(way: 1 | -1): void;
  coarse(is: boolean): void;
}

/** What is said at a step. */
type Said = Pick<Step, "caption" | "equation" | "values">;

/** The steps that the view counts: those of the construction, or its passages. */
function listed(opened: Opened | null, coarse: boolean): Said[] {
  if (opened === null) return [];
  if (!coarse) return opened.steps;
  return opened.passages.map(([first, last], index) => {
    const within = opened.steps.slice(first - 1, last);
    const equations = within.map(({ equation }) => equation).filter((equation) => equation !== "");
    return { caption: opened.passage_captions[index] ?? "", equation: equations.join("\n"), values: within.flatMap(({ values }) => values) };
  });
}

export function steps(app: Shown): Steps {
  const on = signal(app.view.value.step !== null);
  const all = (): Said[] => listed(app.solved.value.opened, app.view.value.coarse);
  const count = (): number => all().length;
  const now = (): number => app.view.value.step ?? count() + 1;

  function go(step: number): void {
    if (app.student.value || count() === 0) return;
    on.set(true);
    const next = Math.min(Math.max(step, 1), count() + 1);
    set(next > count() ? null : next);
  }

  function set(step: number | null): void {
    if (step !== app.view.value.step) app.view.set({ ...app.view.value, step });
  }

  // Another scene has other steps.
  app.solved.on(({ opened }) => {
    const { step } = app.view.value;
    if (opened !== null && step !== null && step > count()) set(null);
  });
  on.on((is) => is || set(null));
  app.view.on(({ step }) => step !== null && on.set(true));
  app.student.on((is) => is && on.set(false));

  return {
    on,
    count,
    now,
    said: () => (app.view.value.step === null ? null : (all()[app.view.value.step - 1] ?? null)),
    go,
    by: (way) => go(now() + way),
    coarse(is) {
      const { step, coarse } = app.view.value;
      const passages = app.solved.value.opened?.passages ?? [];
      if (is === coarse || passages.length === 0) return;
      // The step stays where it was in the construction.
      const index = step === null ? -1 : is ? passages.findIndex(([, last]) => step <= last) : step - 1;
      const next = step === null || index < 0 ? null : is ? index + 1 : (passages[index]?.[1] ?? null);
      app.view.set({ ...app.view.value, coarse: is, step: next });
    },
  };
}
