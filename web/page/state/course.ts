/**
 * A course that the page is a part of: its management system is told how much is right, and keeps what is written for the next visit (SCORM 1.2,
 * Run-Time Environment).
 *
 * A system may be faulty: a call of it may be missing, throw or be refused, and all of it may go away. The page stays what it is then, and the student
 * hears that the marks are not taken.
 */
import { packed, unpacked } from "./suspended.ts";
import { signal, type Signal } from "./signal.ts";

/** What a management system should offer in a window above the page. */
const CALLS = ["LMSInitialize", "LMSFinish", "LMSGetValue", "LMSSetValue", "LMSCommit"] as const;
type Call = (typeof CALLS)[number];
type Api = Partial<Record<Call, (...given: string[]) => unknown>>;

/** What a check has found. */
export interface Marked {
  earned: number;
  of: number;
  /** Whether every box has been filled and judged. */
  isFull: boolean;
  /** Whether all that is asked for is there and right. */
  isRight: boolean;
}

/** A course. */
export interface Course {
  /** The marking scheme that counts: every box is worth what the exercise says. */
  readonly scheme: string;
  /** Whether it does not take the marks. */
  readonly isDeaf: Signal<boolean>;
  /** The form to begin with: what an earlier visit has left, else the empty one. */
  readonly form: string;
  /** The drawing that an earlier visit has left; empty where there is none. */
  readonly drawing: string;
  /** From now on form and drawing are kept for the next visit, as they stand when the course is told something. */
  follow(now: () => { form: string; drawing?: string }): void;
  /** Says what a check has found; the best of all counts. */
  report(marked: Marked): void;
  /** Says again what was said last. */
  again(): void;
}

/** How many frames may lie between the page and the course. */
const DEEPEST = 10;

/** The interface in a window or in one above it; null where there is none, or where it belongs to somebody else. */
function above(page: Window | null): Api | null {
  try {
    for (let depth = 0; page !== null && depth < DEEPEST; depth += 1) {
      const { API } = page as Window & { API?: unknown };
      if (typeof API === "object" && API !== null && CALLS.some((call) => call in API)) return API;
      if (page.parent === page) return null;
      page = page.parent;
    }
  } catch {
    // A window of another origin does not say what it has.
  }
  return null;
}

/** The interface, looked for anew each time, for it may come and go. */
const api = (): Api | null => above(window) ?? above(window.opener as Window | null);

/** What a course answers; null where it does not. */
function asked(call: Call, ...given: string[]): string | null {
  try {
    const answer = api()?.[call]?.(...given);
    return answer == null ? null : String(answer);
  } catch {
    return null;
  }
}

/** Whether a course has done what it was asked for. */
const isDone = (call: Call, ...given: string[]): boolean => ["true", "1"].includes(asked(call, ...given) ?? "");
const put = (element: string, value: string): boolean => isDone("LMSSetValue", `cmi.${element}`, value);
const known = (element: string): string => asked("LMSGetValue", `cmi.${element}`) ?? "";
/** A number that a course knows; null where it knows none. */
const numberOf = (element: string): number | null => {
  const text = known(element).trim();
  return text === "" || !Number.isFinite(Number(text)) ? null : Number(text);
};

/** A span of time as courses write it. */
function span(milliseconds: number): string {
  const two = (x: number): string => String(x).padStart(2, "0");
  const seconds = Math.round(milliseconds / 1000);
  return `${two(Math.floor(seconds / 3600))}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
}

/** The course that has opened the page with an exercise of that empty form; null where none has. */
export function course(empty: string): Course | null {
  if (api() === null) return null;
  // Whoever has begun the session ends it: mostly the page around this one. To begin a second time is an error (101).
  const isOurs = known("core.lesson_status") === "";
  if (isOurs) asked("LMSInitialize", "");
  const begun = performance.now();
  const before = unpacked(known("suspend_data"));
  const pass = numberOf("student_data.mastery_score");
  let best = Math.max(before?.best ?? 0, numberOf("core.score.raw") ?? 0);
  let isMarked = best > 0 || before?.best != null;
  let status = known("core.lesson_status");
  const form = before?.into(empty) ?? empty;
  let written = (): { form: string; drawing?: string } => ({ form, drawing: before?.drawing ?? "" });
  const isDeaf = signal(false);

  const tell = (): void => {
    const isOver = ["completed", "passed"].includes(status);
    // A score that does not pass ends a session as failed, so one that must pass is told when all boxes are filled.
    const isTold = isMarked && (pass === null || isOver || status === "failed");
    put("core.session_time", span(performance.now() - begun));
    put("core.exit", isOver ? "" : "suspend");
    put("suspend_data", packed(isMarked ? best : null, written().form, empty, written().drawing));
    if (isTold) {
      put("core.score.min", "0");
      put("core.score.max", "100");
    }
    // What a system need not know is no matter.
    const taken = [
      !isTold || put("core.score.raw", String(best)),
      put("core.lesson_status", isOver || status === "failed" ? status : "incomplete"),
      isDone("LMSCommit", ""),
    ];
    isDeaf.set(!taken.every(Boolean));
  };
  tell();
  window.addEventListener("pagehide", () => {
    tell();
    if (isOurs) asked("LMSFinish", "");
  }, { once: true });
  return {
    scheme: '{ "kinegon_marks": 1 }',
    isDeaf,
    form,
    drawing: before?.drawing ?? "",
    follow: (now) => (written = now),
    report({ earned, of, isFull, isRight }) {
      const score = of > 0 ? Math.round((1000 * earned) / of) / 10 : 0;
      if (pass === null || isFull) [best, isMarked] = [Math.max(best, score), true];
      if (pass === null && isFull && isRight) status = "completed";
      if (pass !== null && isFull && status !== "passed") status = best >= pass ? "passed" : "failed";
      tell();
    },
    again: tell,
  };
}
