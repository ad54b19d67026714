import { element } from "../../dom/element.ts";
import type { Checked } from "../../engine/types.ts";
import type { Verdicts } from "./checking.ts";
import { SIGNS } from "./verdict.ts";
import { say } from "./words.ts";

const COUNTED = ["right", "within-tolerance", "sense-missing", "off"] as const;

/** How many values have each verdict, by signs; the sentence that says it is their name. */
function counts(checked: Checked): Node[] {
  const values = checked.result?.values ?? [];
  const all = COUNTED.map((kind) => ({ kind, count: values.filter((value) => value.verdict === kind).length }));
  const seen = all.filter(({ count }) => count > 0).map(({ kind, count }) => element("span", { "data-kind": kind, "aria-hidden": "true" }, `${SIGNS[kind]} ${count}`));
  const told = element("span", { class: "unseen" });
  told.innerHTML = checked.parts?.counts ?? "";
  return [...seen, told];
}

/** The line that stays at the foot of the panel: how many values are right, and the way to what happened. */
export function bar(goTo: { result(): void; firstOff(): void }): { root: HTMLElement; show(verdicts: Verdicts, filled: number, all: number): void } {
  const text = element("span", { class: "counts", role: "status" });
  const off = element("button", { type: "button" });
  const more = element("button", { type: "button" });
  off.onclick = goTo.firstOff;
  more.onclick = goTo.result;
  const root = element("div", { class: "foot" }, text, off, more);
  return {
    root,
    show({ checked, refused, isChecking }, filled, all) {
      const isOff = checked?.result?.values.some((value) => value.verdict === "off") === true;
      root.classList.toggle("busy", isChecking);
      off.textContent = say("first_off");
      more.textContent = say("to_result");
      off.hidden = !isOff;
      more.hidden = checked === null && refused === null;
      if (checked?.parts === null || checked === null) text.textContent = say("filled", { filled, all });
      else text.replaceChildren(...counts(checked));
      text.title = text.querySelector(".unseen")?.textContent ?? "";
    },
  };
}
