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

/** The number with the sign of a sense. */
export function signed(size: string, sense: Sense, turns: boolean, positive: FormFile["positive"]): string {
  if (size.trim() === "" || sense === "") return size;
  const isFlipped = turns && positive === "clockwise";
  return ((sense === "+") !== isFlipped ? "+" : "-") + size.trim();
}
