import type { CheckResult, Form, FormRow } from "../../engine/types.ts";
import { scaleOf } from "../../sheets.ts";
import type { Verdicts } from "./checking.ts";
import { filledNames, type FormFile, valueOf } from "./form.ts";
import { taken } from "./units.ts";
import { fault, kindOf, type Verdict } from "./verdict.ts";
import { say } from "./words.ts";

/** What stands beside a box: the verdict on its value, the value that marked points give where none is written, and what a value with a unit comes to. */
export interface Judged {
  verdict: Verdict | null;
  fromPoints: string | null;
  is: string | null;
}

/** Mistakes with units: what was drawn is right, so it is told at once, and no hint is needed. */
const OF_UNITS = ["other-unit", "wrong-unit", "degrees-for-radians", "revolutions-for-radians", "revolutions-per-second"];
/** From this probability on a cause is told. */
const SURE = 0.6;

/** By their quantities: values that are written in another unit than meant, with what was meant. */
function unitsMistaken(result: CheckResult | null | undefined): Map<string, string> {
  const { mistakes, probability } = result?.diagnosis ?? { mistakes: [], probability: 0 };
  const told = mistakes.filter(({ mistake }) => probability >= SURE && OF_UNITS.includes(mistake));
  // The box says itself which quantity it is; what is said of several stands beside the first.
  return new Map(told.flatMap(({ written: [name] = [], done, should_be }) => (name === undefined ? [] : [[name, `${plainly(done).replace(`${name}: `, "")}: ${plainly(should_be)}`] as const])));
}

/** A sentence of results, in which letters have their indices behind a stroke. */
const plainly = (told: string): string => told.replace(/[_{}]/g, "");

/** What a value with a unit beside it comes to: in mm of paper where it is a length there, else in the scene's unit; null where no unit is beside it. */
export function comesTo(value: number, row: FormRow, file: FormFile, form: Form): string | null {
  const { digits, unit, onPaper } = valueOf(file, row.name);
  if (onPaper || (unit === null && taken(digits).unit === null)) return null;
  const scale = row.on_paper ? (file[scaleOf(row.panel)] ?? form.scales[row.panel]) : null;
  const rounded = (x: number): string => String(Number(x.toPrecision(5)));
  return scale ? say("is_on_paper", { value: rounded(value / scale) }) : `= ${rounded(row.has_sense ? Math.abs(value) : value)} ${row.unit}`;
}

/** The verdicts by the names of the boxes; values without a box are there, too, with why they are not understood. */
export function judged(file: FormFile, form: Form, { checked }: Verdicts, unchecked: ReadonlySet<string>): Map<string, Judged> {
  const filled = new Set(filledNames(file));
  const boxes = new Map(form.rows.map((row) => [row.name, row]));
  const mistaken = unitsMistaken(checked?.result);
  const found = new Map<string, Judged>();
  checked?.parts?.rows.forEach(({ name, cells }, index) => {
    if (found.has(name)) return;
    const value = checked.result?.values[index];
    const kind = kindOf(value?.verdict ?? "");
    const hint = kind === "sense-missing" ? say("choose_sense") : (mistaken.get(value?.quantity ?? "") ?? null);
    const isWritten = filled.has(name);
    const row = boxes.get(name);
    const is = isWritten && value !== undefined && row !== undefined ? comesTo(value.value, row, file, form) : null;
    found.set(name, { verdict: { kind, words: plain(cells[7]), hint }, fromPoints: isWritten ? null : String(Number(value?.value.toPrecision(4))), is });
  });
  for (const { name, message, hint } of checked?.faults ?? []) found.set(name.replace(/\/mu$/, ""), { verdict: fault(message, hint), fromPoints: null, is: null });
  for (const name of filled) if (!boxes.has(name) && !found.has(name)) found.set(name, { verdict: fault("", null), fromPoints: null, is: null });
  for (const name of unchecked) found.set(name, { verdict: { kind: "writing", words: say("typing"), hint: null }, fromPoints: null, is: null });
  return found;
}

/** A fragment of the engine without its scripts. */
function plain(html: string | undefined): string {
  const holder = document.createElement("template");
  holder.innerHTML = html ?? "";
  return holder.content.textContent ?? "";
}
