import type { App } from "../app.ts";
import { signal, type Signal } from "./signal.ts";

/** Whether an exam is under way: a student's link asks for one, and the drawing of this scene has not been handed in. Nothing is judged, hinted or shown meanwhile. */
export function examOf({ student, board, history }: Pick<App, "student" | "board" | "history">): Signal<boolean> {
  const isUnderWay = (): boolean => student.value && board.value?.mode === "exam" && board.value.handed_in !== history.now.value.text;
  const exam = signal(isUnderWay());
  const look = (): void => exam.set(isUnderWay());
  student.on(look);
  board.on(look);
  history.now.on(look);
  return exam;
}
