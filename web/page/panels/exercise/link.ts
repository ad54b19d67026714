import type { App } from "../../app.ts";
import type { Exercise } from "../../engine/types.ts";
import type { BoardUse } from "../../state/address.ts";
import type { Wanted } from "./making.ts";
import { begun, formText } from "../check/form.ts";

/** What the teacher allows. */
export interface Allowed {
  steps: boolean;
  more: boolean;
  /** How the drawing board is used; null where the student draws on paper. */
  board: BoardUse | null;
}

/**
 * The address that a student gets: the exercise's scene, its empty form, and what it was made from, for its sheet; without the key. The plans are
 * not shown.
 */
export async function studentLink(app: App, exercise: Exercise, { text, name, seed, number, options }: Wanted, { steps, more, board }: Allowed): Promise<string> {
  const isOwn = !(await app.engine.kinds()).some((kind) => kind.name === name && kind.text === text);
  const task = { name, text: isOwn ? text : "", seed, number, options, steps, more };
  return app.link({ text: exercise.text, form: formText(begun(exercise.form, true)), panel: "check", student: true, task, ...(board !== null && { board }) });
}
