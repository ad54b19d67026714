import { evaluated } from "../../number.ts";
import { parted } from "../../units.ts";

/** Units that may stand beside a value, by the scene's own unit of it; the first is that one. docs/checking.md names all that are understood. */
const LENGTHS = ["mm", "cm", "m", "in", "ft"];

export function unitsBeside(own: string): string[] {
  return [...new Set([own, ...alike(own)])];
}

function alike(own: string): string[] {
  if (own === "°") return ["rad"];
  if (own.startsWith("rad")) return own.endsWith("²") ? ["rad/s²", "°/s²"] : ["rad/s", "°/s", "rpm"];
  const [, time = ""] = /^[a-z]+(\/.+)?$/.exec(own) ?? [];
  return LENGTHS.map((length) => length + time);
}

/** A number alone. */
const ALONE = /^[+\-−–]?[\d.,]+(?:[eE][+\-−]?\d+)?$/;

/** As many digits of what a formula comes to as a hand can draw. */
const DIGITS = 6;

/** The number of a text: as it stands there, or what a formula comes to; null where it is none. */
function digitsOf(text: string): string | null {
  if (ALONE.test(text)) return text;
  const value = evaluated(text);
  return value === null ? null : String(Number(value.toPrecision(DIGITS)));
}

/** What was typed: its number, and the unit behind it where one stands there, as in `0.06 m/s`, `12,5rpm`, `325/2 mm`. */
export function taken(typed: string): { digits: string; unit: string | null } {
  const text = typed.trim();
  if (ALONE.test(text)) return { digits: text, unit: null };
  const { number, unit } = parted(text);
  return { digits: digitsOf(number) ?? number, unit: unit?.replace(/\^?2$/, "²") ?? null };
}

/** Whether a formula was typed, and not its number. */
export function isFormula(typed: string): boolean {
  const { number } = parted(typed);
  return !ALONE.test(number) && digitsOf(number) !== null;
}

/** What stands in the form: the unit that was typed stays with its number, and goes with it. */
export function withTyped(digits: string, unit: string | null): string {
  return unit === null || digits === "" ? digits : `${digits} ${unit}`;
}
