import type { Form } from "../../engine/types.ts";
import type { Verdicts } from "./checking.ts";
import { filledNames, type FormFile } from "./form.ts";
import { fault, kindOf, type Verdict } from "./verdict.ts";
import { say } from "./words.ts";

/** What stands beside a box: the verdict on its value, and the value that marked points give where none is written. */
export interface Judged {
  verdict: Verdict | null;
  fromPoints: string | null;
}

/** The verdicts by the names of the boxes; values without a box are there, too, with why they are not understood. */
export function judged(file: FormFile, form: Form, { checked }: Verdicts, unchecked: ReadonlySet<string>): Map<string, Judged> {
  const filled = new Set(filledNames(file));
  const found = new Map<string, Judged>();
  checked?.parts?.rows.forEach(({ name, cells }, index) => {
    if (found.has(name)) return;
    const value = checked.result?.values[index];
    const kind = kindOf(value?.verdict ?? "");
    const hint = kind === "sense-missing" ? say("choose_sense") : null;
    const isWritten = filled.has(name);
    found.set(name, { verdict: { kind, words: plain(cells[7]), hint }, fromPoints: isWritten ? null : String(Number(value?.value.toPrecision(4))) });
  });
  for (const { name, message, hint } of checked?.faults ?? []) found.set(name.replace(/\/mu$/, ""), { verdict: fault(message, hint), fromPoints: null });
  const boxes = new Set(form.rows.map((row) => row.name));
  for (const name of filled) if (!boxes.has(name) && !found.has(name)) found.set(name, { verdict: fault("", null), fromPoints: null });
  for (const name of unchecked) found.set(name, { verdict: { kind: "writing", words: say("typing"), hint: null }, fromPoints: null });
  return found;
}

/** A fragment of the engine without its scripts. */
function plain(html: string | undefined): string {
  const holder = document.createElement("template");
  holder.innerHTML = html ?? "";
  return holder.content.textContent ?? "";
}
