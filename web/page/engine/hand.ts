import { language } from "../words.ts";
import type { Refused } from "./types.ts";
import type { Answer } from "./worker.ts";

/** Longer than this no call may run. */
export const PATIENCE = 20_000;

/** Functions whose answers are no JSON. */
const PLAIN = new Set(["drop", "edit", "edit_in_place", "move_points", "choose_mode", "file", "font", "read_form", "write_form", "exercise_file", "free", "board_form", "board_own", "board_sheets"]);

interface Waiting {
  name: string;
  given: unknown[];
  of: number;
  done(value: unknown): void;
  refused(why: Refused): void;
}

/** What happens to an engine. */
export interface Watch {
  /** It works longer than it takes to notice, or is idle again. */
  busy(is: boolean): void;
  /** It was started again. The answer is what the caller is told. */
  restarted(why: Why, during: string): string;
}

/** Why an engine is started again: it fell, took too long, or somebody would not wait. */
export type Why = "fell" | "too_slow" | "stopped";

/** One worker with its engine. */
export interface Hand {
  /** `of` is the number of the engine: in a page with several components each has its own. */
  call(name: string, given: unknown[], of?: number): Promise<unknown>;
  /** Breaks off what is under way, if anything is, with all that waits for it. */
  stop(): void;
}

/** A refusal that is about no place in a text. */
export function refusal(message: string): Refused {
  return { message, hint: null, path: "", from: null, to: null, line: null, column: null };
}

/** Time that the engine itself took for its last answer, in ms. */
export const lastTook = { ms: 0 };

/**
 * One worker with one engine. Calls are answered in their order, one at a time; those that wait stay on this side, so that
 * nothing but the running call is lost when the engine has to be started again by itself.
 */
export function hand(address: string, module: WebAssembly.Module, watch: Watch): Hand {
  const queue: Waiting[] = [];
  let running: Waiting | undefined;
  let clock = 0;
  let notice = 0;
  let worker = started();

  function started(): Worker {
    const made = new Worker(address);
    made.onmessage = ({ data }: MessageEvent<Answer>) => answered(data);
    made.onerror = (event) => {
      event.preventDefault();
      fall("fell");
    };
    made.postMessage({ module });
    return made;
  }

  function settle(): Waiting | undefined {
    const call = running;
    running = undefined;
    clearTimeout(clock);
    clearTimeout(notice);
    watch.busy(false);
    return call;
  }

  function fall(why: Why): void {
    worker.terminate();
    const call = settle();
    worker = started();
    const told = watch.restarted(why, call?.name ?? "");
    call?.refused(refusal(told));
    if (why === "stopped") for (const waiting of queue.splice(0)) waiting.refused(refusal(told));
    next();
  }

  function answered(data: Answer): void {
    if ("fell" in data) return fall("fell");
    const call = settle();
    lastTook.ms = data.took;
    next();
    if (call === undefined) return;
    if ("refused" in data) call.refused(JSON.parse(data.refused) as Refused);
    else call.done(PLAIN.has(call.name) ? data.value : JSON.parse(data.value as string));
  }

  function next(): void {
    if (running !== undefined) return;
    running = queue.shift();
    if (running === undefined) return;
    clock = window.setTimeout(() => fall("too_slow"), PATIENCE);
    notice = window.setTimeout(() => watch.busy(true), 200);
    const { name, given, of } = running;
    // Bytes are handed over, not copied.
    worker.postMessage({ name, given, of, language: language.value }, given.flatMap((one) => (one instanceof Uint8Array ? [one.buffer] : [])));
  }

  return {
    call: (name, given, of = 0) =>
      new Promise((done, refused) => {
        queue.push({ name, given, of, done, refused });
        next();
      }),
    stop() {
      if (running !== undefined) fall("stopped");
    },
  };
}
