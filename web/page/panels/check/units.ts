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

/** A number with a unit behind it, as somebody types them together: `0.06 m/s`, `12,5rpm`. */
const TOGETHER = /^\s*([+\-−–]?[\d.,\s]*\d[\d.,]*(?:[eE][+\-−]?\d+)?)\s*([^\d\s.,+\-].*?)\s*$/;

/** A number alone. */
const ALONE = /^[+\-−–]?[\d.,]+(?:[eE][+\-−]?\d+)?$/;

/** What was typed, with the unit apart where one stands there. */
export function taken(typed: string): { digits: string; unit: string | null } {
  if (ALONE.test(typed.trim())) return { digits: typed.trim(), unit: null };
  const [, digits, unit] = TOGETHER.exec(typed) ?? [];
  if (digits === undefined || unit === undefined) return { digits: typed.trim(), unit: null };
  return { digits: digits.trim(), unit: unit.replace(/\^?2$/, "²") };
}
