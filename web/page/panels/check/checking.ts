import type { App } from "../../app.ts";
import type { Checked, Refused } from "../../engine/types.ts";
import { newest } from "../../state/newest.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { formFile, hasValues } from "./form.ts";

/** What the check says of the form. */
export interface Verdicts {
  /** Of the form's present text; of an earlier one while that is being checked. */
  checked: Checked | null;
  /** Why the form as a whole is refused. */
  refused: Refused | null;
  isChecking: boolean;
}

/** How long somebody must pause within a field before it is checked, in ms. */
const PAUSE = 900;

export interface Checking {
  verdicts: Signal<Verdicts>;
  /** The marking scheme: its file's name and its text. */
  scheme: Signal<{ name: string; text: string } | null>;
  /** The field in which somebody is writing, by its name in the form; null as soon as it is left, or after a pause. */
  writing: Signal<string | null>;
  /** The fields whose present values have not been checked yet. */
  unchecked: Set<string>;
}

/** Checks the form whenever it has changed, except in an exam; one check is under way at a time, and the newest form wins. */
export function checking(app: App): Checking {
  const verdicts = signal<Verdicts>({ checked: null, refused: null, isChecking: false });
  const scheme: Checking["scheme"] = signal<{ name: string; text: string } | null>(null);
  const writing = signal<string | null>(null);
  const unchecked = new Set<string>();
  let pause: ReturnType<typeof setTimeout> | undefined;

  const checks = newest<void>(async () => {
    const { form } = app.history.now.value;
    const { good } = app.solved.value;
    const file = formFile(form);
    if (good === "" || file === null || !hasValues(file) || app.exam.value) {
      unchecked.clear();
      verdicts.set({ checked: null, refused: null, isChecking: false });
      return;
    }
    const under = [...unchecked];
    const settle = (): void => under.forEach((name) => !checks.isStale() && name !== writing.value && unchecked.delete(name));
    verdicts.set({ ...verdicts.value, isChecking: true });
    const options = { marks: scheme.value?.text ?? app.course?.scheme ?? null, pencil_mm: null, pencil_degrees: null, drawn: false };
    try {
      const checked = await app.engine.check(good, form, options);
      settle();
      verdicts.set({ checked, refused: null, isChecking: false });
      if (good === app.asked.text && file.exercise === formFile(app.asked.form)?.exercise) tell(checked);
    } catch (why) {
      settle();
      verdicts.set({ checked: null, refused: why as Refused, isChecking: false });
    }
  });

  /** Tells a course the marks of its exercise; those of a scheme that somebody brings are none of its. */
  function tell({ result, faults }: Checked): void {
    const marks = result?.marks;
    if (marks == null || scheme.value !== null) return;
    const isFull = (result?.missing ?? []).length === 0 && faults.length === 0 && result?.values.every((value) => value.verdict !== "too-coarse") === true;
    app.course?.report({ earned: marks.earned, of: marks.of, isFull, isRight: result?.passed === true });
  }

  function run(): void {
    clearTimeout(pause);
    checks.want();
  }

  let known = { form: "", good: "" };
  function changed(): void {
    const now = { form: app.history.now.value.form, good: app.solved.value.good };
    if (now.form === known.form && now.good === known.good) return;
    known = now;
    clearTimeout(pause);
    if (writing.value === null) run();
    else pause = setTimeout(() => writing.set(null), PAUSE);
  }
  app.history.now.on(changed);
  app.solved.on(changed);
  scheme.on(run);
  app.exam.on(run);
  writing.on((field) => {
    if (field === null) run();
    else unchecked.add(field);
  });
  return { verdicts, scheme, writing, unchecked };
}
