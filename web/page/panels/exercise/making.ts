import type { App } from "../../app.ts";
import type { Exercise, ExerciseOptions, Refused } from "../../engine/types.ts";
import { newest } from "../../state/newest.ts";
import { signal, type Signal } from "../../state/signal.ts";

/** Which exercise is wanted. */
export interface Wanted {
  /** The text of the scene that is varied. */
  text: string;
  /** The name of its kind, or of the scene. */
  name: string;
  seed: number;
  /** Counted from 1. */
  number: number;
  options: ExerciseOptions;
}

export interface Made {
  exercise: Exercise | null;
  /** What the exercise was made from. */
  wanted: Wanted | null;
  refused: Refused | null;
  isMaking: boolean;
}

/** Makes exercises one after the other; the newest that is wanted wins. */
export function making(app: App): { made: Signal<Made>; make(wanted: Wanted): void } {
  const made = signal<Made>({ exercise: null, wanted: null, refused: null, isMaking: false });
  const { want } = newest(async (wanted: Wanted) => {
    made.set({ ...made.value, isMaking: true });
    const { text, name, seed, number, options } = wanted;
    try {
      const exercise = await app.engine.exercise(text, name, seed, number, options);
      made.set({ exercise, wanted, refused: null, isMaking: false });
    } catch (why) {
      made.set({ exercise: null, wanted, refused: why as Refused, isMaking: false });
    }
  });
  return { made, make: want };
}
