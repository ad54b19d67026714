import type { FormFile } from "./form.ts";

/** A sense: counter-clockwise or along the guide; clockwise or against it; not chosen. */
export type Sense = "+" | "-" | "";

/** Signs as people and keyboards write them. */
const SIGN = /^\s*([+\-−–])\s*/;

/** The size of a number, and the sense that its sign tells in a form that counts this sense as positive. */
export function sensed(digits: string, turns: boolean, positive: FormFile["positive"]): { size: string; sense: Sense } {
  const sign = SIGN.exec(digits)?.[1];
  const size = digits.replace(SIGN, "");
  if (size.trim() === "") return { size, sense: "" };
  // Without a sign the form's own positive sense holds, where it names one.
  if (sign === undefined && positive === undefined) return { size, sense: "" };
  const isPlus = sign === undefined || sign === "+";
  const isFlipped = turns && positive === "clockwise";
  return { size, sense: isPlus !== isFlipped ? "+" : "-" };
}

/** Whether a number is 0, which has no sense. */
export const isZero = (digits: string): boolean => /^\s*[+\-−–]?\s*0*[.,]?0+\s*$/.test(digits);

/** The sense that is chosen, and where it comes from. */
export interface Chosen {
  sense: Sense;
  /** Whether a sign in the box has set it, and no button: with the number it goes. */
  isTyped: boolean;
  /** Whether the box has a sign. */
  hasSign: boolean;
}

/** What is chosen when the box has these digits. `isAnew`: nothing of what it had before is left. */
export function afterTyping({ sense, isTyped, hasSign }: Chosen, digits: string, isAnew: boolean, turns: boolean, positive: FormFile["positive"]): Chosen {
  const hasNow = SIGN.test(digits);
  const typed = hasNow ? sensed(digits, turns, positive).sense : "";
  if (typed !== "") return { sense: typed, isTyped: true, hasSign: true };
  const isGone = isTyped && !hasNow && (isAnew || hasSign || digits.trim() === "");
  return { sense: isGone ? "" : sense, isTyped: isTyped && !isGone, hasSign: hasNow };
}

/** The number with the sign of a sense. */
export function signed(size: string, sense: Sense, turns: boolean, positive: FormFile["positive"]): string {
  if (size.trim() === "" || sense === "" || isZero(size)) return size;
  const isFlipped = turns && positive === "clockwise";
  return ((sense === "+") !== isFlipped ? "+" : "-") + size.trim();
}
