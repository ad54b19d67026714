/**
 * A course that the page is a part of: its management system is told how much is right (SCORM 1.2, Run-Time Environment).
 *
 * A system may be faulty: a call of it may be missing, throw or be refused, and all of it may go away. The page stays what it is then, and the student
 * hears that the marks are not taken.
 */
import { signal, type Signal } from "./signal.ts";

/** What a management system should offer in a window above the page. */
const CALLS = ["LMSInitialize", "LMSFinish", "LMSGetValue", "LMSSetValue", "LMSCommit"] as const;
type Call = (typeof CALLS)[number];
type Api = Partial<Record<Call, (...given: string[]) => unknown>>;

/** A course. */
export interface Course {
  /** The marking scheme that counts: every box alike. */
  readonly scheme: string;
  /** Whether it does not take the marks. */
  readonly isDeaf: Signal<boolean>;
  /** Says how many marks are earned of how many, and whether all boxes are filled; the best of all counts. */
  report(earned: number, of: number, isFull: boolean): void;
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

/** The course that has opened the page; null where none has. */
export function course(): Course | null {
  if (api() === null) return null;
  // The page before this one may have begun already; then this is refused, and nothing is lost.
  const isDeaf = signal(asked("LMSInitialize", "") === null);
  const before = Number(asked("LMSGetValue", "cmi.core.score.raw"));
  let best = Number.isFinite(before) ? before : 0;
  let isComplete = ["completed", "passed"].includes(asked("LMSGetValue", "cmi.core.lesson_status") ?? "");
  const tell = (): void => {
    const taken = [
      isDone("LMSSetValue", "cmi.core.score.min", "0"),
      isDone("LMSSetValue", "cmi.core.score.max", "100"),
      isDone("LMSSetValue", "cmi.core.score.raw", String(best)),
      isDone("LMSSetValue", "cmi.core.lesson_status", isComplete ? "completed" : "incomplete"),
      isDone("LMSCommit", ""),
    ];
    // A system that knows no least score takes the score all the same.
    isDeaf.set(!taken.slice(2).every(Boolean));
  };
  window.addEventListener("pagehide", () => {
    if (isDeaf.value) tell();
    asked("LMSFinish", "");
  }, { once: true });
  return {
    scheme: '{ "kinegon_marks": 1 }',
    isDeaf,
    report(earned, of, isFull) {
      best = Math.max(best, of > 0 ? Math.round((1000 * earned) / of) / 10 : 0);
      isComplete ||= isFull;
      tell();
    },
    again: tell,
  };
}
