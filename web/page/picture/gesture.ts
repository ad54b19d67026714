import type { Shown } from "../app.ts";
import { lastTook } from "../engine/hand.ts";
import type { Grab, Picture, Pull, Refused, View } from "../engine/types.ts";
import type { Signal } from "../state/signal.ts";
import type { Current } from "./picture.ts";

/** How long a picture took, in ms. */
export interface Frame {
  /** The engine's own time. */
  engine: number;
  /** Putting the picture into the page. */
  page: number;
  /** From the pull to the picture in the page. */
  total: number;
}

/** The pictures since the page was opened, the last ten thousand. */
export const frames: Frame[] = [];

/** How long the keyboard may rest before a gesture by keys is over, in ms. */
export const REST = 700;

/** What is dragged at present. */
export interface Gesture {
  /** Where to. The newest pull wins. */
  pull(to: Pull): void;
  /** Lets go: the text after it is one entry of the history. */
  drop(): Promise<void>;
  /** Lets go and puts everything back. */
  cancel(): Promise<void>;
  /** Whether it goes on: nobody has let go, taken hold of something else, or made it fail. */
  isHeld(): boolean;
}

/** Takes hold of something; what was held before is let go. */
export type Gestures = {
  start(what: Grab): Promise<Gesture | null>;
  /** Ends what goes on, if anything does. */
  end(): Promise<void>;
  isActive(): boolean;
};

/** `show` puts a picture on the page, `back` shows the document on its surface again, `ease` lets it ease over to its new layout. */
export function gestures(app: Shown, sight: Signal<View>, show: (picture: Picture) => void, { again: back, ease }: Current): Gestures {
  let current: Gesture | null = null;

  /** A picture goes into the page as soon as it is there, but only one for each frame of the screen: a later one waits for the next. */
  let isFrameTaken = false;
  let next: (() => void) | null = null;

  function frame(): void {
    isFrameTaken = next !== null;
    next?.();
    next = null;
    if (isFrameTaken) requestAnimationFrame(frame);
  }

  function present(picture: Picture, pulled: number): void {
    const engine = lastTook.ms;
    const put = (): void => {
      const begin = performance.now();
      show(picture);
      const end = performance.now();
      frames.push({ engine, page: end - begin, total: end - pulled });
      performance.measure("kinegon-frame", { start: pulled, end });
      if (frames.length <= 10_000) return;
      frames.splice(0, 5_000);
      performance.clearMeasures("kinegon-frame");
    };
    if (isFrameTaken) next = put;
    else {
      isFrameTaken = true;
      put();
      requestAnimationFrame(frame);
    }
  }

  async function start(what: Grab): Promise<Gesture | null> {
    await end();
    const { good, text, refused } = app.solved.value;
    if (refused !== null || app.student.value || text !== app.history.now.value.text) return null;
    let view = sight.value;
    let wanted: { to: Pull; at: number } | null = null;
    let flight: Promise<void> | null = null;
    let isOver = false;

    /** What is answered after the end is not shown: it would wait for the next frame, and could cover the document's picture. */
    const shown = (picture: Picture, pulled: number): void => {
      if (!isOver) present(picture, pulled);
    };

    /** Another step is shown while something is held: it is let go and taken again on the sheet of that step. */
    async function follow(): Promise<void> {
      view = sight.value;
      const at = performance.now();
      shown(await app.engine.grab(await app.engine.drop(), view, what), at);
    }

    async function pump(): Promise<void> {
      while (wanted !== null || view !== sight.value) {
        if (view !== sight.value) await follow();
        if (wanted === null) break;
        const { to, at } = wanted;
        wanted = null;
        shown(await app.engine.drag(to), at);
      }
      flight = null;
    }

    function run(): void {
      flight ??= pump().catch((why: Refused) => {
        flight = null;
        failed(why);
      });
    }
    const unlisten = sight.on(() => view !== sight.value && run());
    // Somebody changes the scene while it is held: what was held belongs to the old one.
    const unwatch = app.history.now.on((now) => now.text !== text && void gesture.cancel());

    function over(): void {
      isOver = true;
      next = null;
      unlisten();
      unwatch();
      if (current === gesture) current = null;
    }

    function failed(why: Refused): void {
      over();
      app.tell(why.message);
      back();
    }

    const gesture: Gesture = {
      pull(to) {
        if (isOver) return;
        wanted = { to, at: performance.now() };
        run();
      },
      async drop() {
        if (isOver) return;
        await flight;
        if (isOver) return;
        over();
        try {
          const next = await app.engine.drop();
          if (next === text || app.history.now.value.text !== text) return back();
          // A drive goes on where it was; a mechanism of another shape, and another position on paper, has a layout of its own.
          if (what.kind === "shape" || app.paper.value) ease();
          app.history.change({ text: next });
        } catch (why) {
          failed(why as Refused);
        }
      },
      async cancel() {
        if (isOver) return;
        over();
        wanted = null;
        await flight;
        await app.engine.drop().catch(() => undefined);
        back();
      },
      isHeld: () => !isOver,
    };
    current = gesture;
    try {
      shown(await app.engine.grab(good, view, what), performance.now());
    } catch (why) {
      failed(why as Refused);
      return null;
    }
    return gesture;
  }

  async function end(): Promise<void> {
    await current?.drop();
  }

  return { start, end, isActive: () => current !== null };
}
