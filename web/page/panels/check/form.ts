/** The form file: JSON as `kinegon check` reads it. Everything here is text in, text out; the values stay as they were written. */

import type { Scale, Sheet } from "../../sheets.ts";

/** A value as it stands in the file. */
type Written = string | number | { value: string | number; unit: string };

/** A place on paper in mm, x to the right, y up; then the radius that holds it with 95 %, where a photograph tells. */
export type Place = [x: number, y: number, band?: number];

/** A form file; its head has the scales of the student's own sheets. */
export interface FormFile extends Partial<Record<Scale, number>> {
  kinegon_measured: 1;
  name?: string;
  exercise?: string;
  positive?: "counter-clockwise" | "clockwise";
  in?: "mm" | "units";
  /** How many stages of hints were opened; all of every value once the right plan was shown. */
  hints?: number;
  values?: Record<string, Written>;
  points?: Partial<Record<Sheet, Record<string, Place>>>;
}

/** A value for the hand: its digits, perhaps with the unit that was typed behind them; the unit that was chosen beside it (null: the scene's); whether it is in mm of paper. */
export interface Value {
  digits: string;
  unit: string | null;
  onPaper: boolean;
}

/** Behind a name: the value is in mm of paper. */
const ON_PAPER = "/mu";

/** The file of a form's text; null where it is empty or no form. */
export function formFile(text: string): FormFile | null {
  try {
    const file: unknown = JSON.parse(text);
    return typeof file === "object" && file !== null && "kinegon_measured" in file ? (file as FormFile) : null;
  } catch {
    return null;
  }
}

/** The text of a form. */
export function formText(file: FormFile): string {
  return `${JSON.stringify(file, null, 2)}\n`;
}

/** A form to begin with: the scene's empty one. Senses are chosen value by value, so that none is right by chance. */
export function begun(empty: string, inMm: boolean): FormFile {
  const { positive: _, values, ...head } = formFile(empty) ?? { kinegon_measured: 1 as const };
  return { ...head, ...(inMm ? { in: "mm" as const } : {}), ...(values === undefined ? {} : { values }) };
}

function parts(written: Written | undefined): { digits: string; unit: string | null } {
  if (typeof written === "object" && written !== null) return { digits: String(written.value), unit: written.unit };
  return { digits: written === undefined ? "" : String(written), unit: null };
}

/** The value of a box. */
export function valueOf(file: FormFile, name: string): Value {
  const values = file.values ?? {};
  const marked = values[name + ON_PAPER];
  const isMarked = marked !== undefined;
  return { ...parts(isMarked ? marked : values[name]), onPaper: isMarked };
}

/** The form with another value in a box; boxes keep their order. */
export function withValue(file: FormFile, name: string, { digits, unit, onPaper }: Value): FormFile {
  const key = onPaper ? name + ON_PAPER : name;
  const value: Written = unit === null || digits === "" ? digits : { value: digits, unit };
  const values: Record<string, Written> = {};
  let isThere = false;
  for (const [other, old] of Object.entries(file.values ?? {})) {
    const isOwn = other === name || other === name + ON_PAPER;
    if (!isOwn) values[other] = old;
    else if (!isThere) {
      values[key] = value;
      isThere = true;
    }
  }
  if (!isThere) values[key] = value;
  return { ...file, values };
}

/** The form with so many significant digits in its values at most: what a drawing on the screen gives has more of them than a hand can read. */
export function withFewDigits(file: FormFile, digits: number): FormFile {
  const few = (text: string): string => {
    const number = Number(text);
    const short = String(Number(number.toPrecision(digits)));
    return text.trim() === "" || !Number.isFinite(number) || short.length >= text.length ? text : (text.startsWith("+") ? "+" : "") + short;
  };
  const shortened = (value: Written): Written => (typeof value === "object" ? { ...value, value: few(String(value.value)) } : few(String(value)));
  return { ...file, values: Object.fromEntries(Object.entries(file.values ?? {}).map(([name, value]) => [name, shortened(value)])) };
}

/** The form without a value. */
export function withoutValue(file: FormFile, name: string): FormFile {
  const values = Object.entries(file.values ?? {}).filter(([other]) => other !== name && other !== name + ON_PAPER);
  return { ...file, values: Object.fromEntries(values) };
}

/** The form with its head alone: all boxes empty, no points. */
export function cleared(file: FormFile): FormFile {
  const { points: _, ...rest } = file;
  const names = Object.keys(file.values ?? {}).map((name) => (name.endsWith(ON_PAPER) ? name.slice(0, -ON_PAPER.length) : name));
  return { ...rest, values: Object.fromEntries(names.map((name) => [name, ""])) };
}

/** The form with something else in its head; empty texts and `undefined` are left out. */
export function withHead<Key extends Exclude<keyof FormFile, "values" | "points">>(
  file: FormFile,
  key: Key,
  value: FormFile[Key] | undefined,
): FormFile {
  // The head stands above the values, also where the key is new.
  const { values, points, [key]: _, ...head } = file;
  const isThere = key in file;
  const whole = value === undefined ? head : isThere ? { ...file, [key]: value } : { ...head, [key]: value };
  return { ...whole, ...(values && { values }), ...(points && { points }) } as FormFile;
}

/** All stages of a hint: the plan, the value, the step, what was done. */
export const MOST_HINTS = 4;

/** The form with so many hints opened, unless it says more. */
export function withHints(file: FormFile, hints: number): FormFile {
  return hints > (file.hints ?? 0) ? withHead(file, "hints", hints) : file;
}

/** A form's text with the hints that were opened in another form of the same exercise since: nobody unopens one. */
export function withHintsOf(text: string, later: string): string {
  const [file, { hints = 0, exercise } = {} as FormFile] = [formFile(text), formFile(later) ?? undefined];
  return file === null || file.exercise !== exercise || hints <= (file.hints ?? 0) ? text : formText(withHints(file, hints));
}

/** The places of a plan's points. */
export function placesOf(file: FormFile, plan: Sheet): Record<string, Place> {
  return file.points?.[plan] ?? {};
}

/** The form with a point at another place, or without it. */
export function withPlace(file: FormFile, plan: Sheet, name: string, at: Place | null): FormFile {
  const places = { ...placesOf(file, plan) };
  if (at === null) delete places[name];
  else places[name] = at;
  const points = { ...file.points, [plan]: places };
  if (Object.keys(places).length === 0) delete points[plan];
  const { points: _, ...rest } = file;
  return Object.keys(points).length === 0 ? rest : { ...rest, points };
}

/** Names of the values that are filled in, without `/mu`. */
export function filledNames(file: FormFile): string[] {
  const filled = Object.entries(file.values ?? {}).filter(([, value]) => parts(value).digits.trim() !== "");
  return filled.map(([name]) => (name.endsWith(ON_PAPER) ? name.slice(0, -ON_PAPER.length) : name));
}

/** Whether there is anything to check. */
export function hasValues(file: FormFile): boolean {
  return filledNames(file).length > 0 || Object.keys(file.points ?? {}).length > 0;
}
