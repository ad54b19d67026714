import { element } from "../../dom/element.ts";
import { refusal } from "./refusal.ts";
import { say } from "./words.ts";

/** A verdict beside a value: a sign, a colour (by its kind) and words. */
export interface Verdict {
  kind: "right" | "within-tolerance" | "off" | "sense-missing" | "too-coarse" | "unjudged" | "fault" | "writing";
  words: string;
  /** What to try. */
  hint: string | null;
}

export const SIGNS: Record<Verdict["kind"], string> = {
  right: "✓",
  "within-tolerance": "≈",
  off: "✗",
  "sense-missing": "?",
  "too-coarse": "–",
  unjudged: "–",
  fault: "!",
  writing: "…",
};

/** The kind of a verdict that has this name in results. */
export function kindOf(name: string): Verdict["kind"] {
  return Object.hasOwn(SIGNS, name) ? (name as Verdict["kind"]) : "unjudged";
}

/** Shows a verdict in its place; none where there is none. */
export function showVerdict(place: HTMLElement, verdict: Verdict | null): void {
  place.dataset["kind"] = verdict?.kind ?? "";
  place.replaceChildren();
  if (verdict === null || verdict.kind === "writing") return;
  place.append(element("span", { class: "sign", "aria-hidden": "true" }, SIGNS[verdict.kind]), " ", ...refusal({ message: verdict.words, hint: verdict.hint }));
}

/** The verdict on a value that is not understood. */
export function fault(message: string, hint: string | null): Verdict {
  return { kind: "fault", words: message === "" ? say("not_understood") : message, hint };
}
