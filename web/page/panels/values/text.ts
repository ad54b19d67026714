import type { Value } from "../../engine/types.ts";

/** A value with at most so many digits; it loses none that it lacks. */
export function shortened(value: string, digits: number): string {
  const number = Number(value);
  const has = value.replace(/e.*$/i, "").replace(/^-?0*\.?0*|[-.]/g, "").length;
  if (!Number.isFinite(number) || has <= digits) return value;
  const short = number.toPrecision(digits);
  return short.includes("e") ? String(Number(short)) : short;
}

/** A sentence in which numbers have the digits that one reads: five, of a file's nine or more. */
export function fewDigits(text: string): string {
  return text.replace(/\d+[.,]\d{3,}/g, (number) => {
    const isComma = number.includes(",");
    const short = shortened(isComma ? number.replace(",", ".") : number, 5);
    return isComma ? short.replace(".", ",") : short;
  });
}

/** Values as lines of text with aligned columns. */
export function aligned(values: Value[]): string {
  const rows = values.map(({ name, value, unit, error }) => [name, value, unit, error == null ? "" : `± ${error}`]);
  const widths = [0, 1, 2].map((column) => Math.max(0, ...rows.map((row) => row[column]!.length)));
  const line = ([name, value, ...rest]: string[]): string =>
    [name!.padEnd(widths[0]!), value!.padStart(widths[1]!), rest[0]!.padEnd(widths[2]!), rest[1]!].join("  ").trimEnd();
  return `${rows.map(line).join("\n")}\n`;
}

/** Values as a table for spreadsheets. */
export function csv(values: Value[]): string {
  const cell = (text: string): string => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const rows = values.map(({ name, value, unit, error }) => [name, value, unit, error ?? ""].map(cell).join(","));
  return ["quantity,value,unit,error", ...rows, ""].join("\r\n");
}
