/** A course that the page is a part of: its management system is told how much is right (SCORM 1.2, Run-Time Environment). */

/** What a management system offers in a window above the page; every answer is a text. */
interface Api {
  LMSInitialize(nothing: ""): string;
  LMSFinish(nothing: ""): string;
  LMSGetValue(name: string): string;
  LMSSetValue(name: string, value: string): string;
  LMSCommit(nothing: ""): string;
}

/** A course. */
export interface Course {
  /** The marking scheme that counts: every box alike. */
  readonly scheme: string;
  /** Says how many marks are earned of how many, and whether all boxes are filled; the best of all counts. */
  report(earned: number, of: number, isFull: boolean): void;
}

/** How many frames may lie between the page and the course. */
const DEEPEST = 10;

/** The interface in a window or in one above it; null where there is none, or where it belongs to somebody else. */
function above(page: Window | null): Api | null {
  try {
    for (let depth = 0; page !== null && depth < DEEPEST; depth += 1) {
      const { API } = page as Window & { API?: Api };
      if (typeof API?.LMSSetValue === "function") return API;
      if (page.parent === page) return null;
      page = page.parent;
    }
  } catch {
    // A window of another origin does not say what it has.
  }
  return null;
}

/** The course that has opened the page; null where none has. */
export function course(): Course | null {
  const api = above(window) ?? above(window.opener as Window | null);
  if (api === null) return null;
  // The page before this one may have begun already; then this is refused, and nothing is lost.
  api.LMSInitialize("");
  let best = Number(api.LMSGetValue("cmi.core.score.raw")) || 0;
  let isDone = ["completed", "passed"].includes(api.LMSGetValue("cmi.core.lesson_status"));
  const tell = (): void => {
    api.LMSSetValue("cmi.core.score.min", "0");
    api.LMSSetValue("cmi.core.score.max", "100");
    api.LMSSetValue("cmi.core.score.raw", String(best));
    api.LMSSetValue("cmi.core.lesson_status", isDone ? "completed" : "incomplete");
    api.LMSCommit("");
  };
  window.addEventListener("pagehide", () => void api.LMSFinish(""), { once: true });
  return {
    scheme: '{ "kinegon_marks": 1 }',
    report(earned, of, isFull) {
      best = Math.max(best, of > 0 ? Math.round((1000 * earned) / of) / 10 : 0);
      isDone ||= isFull;
      tell();
    },
  };
}
