import { element } from "../../dom.ts";
import type { Verdicts } from "./checking.ts";
import { say } from "./words.ts";

/** The line that stays at the foot of the panel: how many values are right, and the way to what happened. */
export function bar(goTo: { result(): void; firstOff(): void }): { root: HTMLElement; show(verdicts: Verdicts, filled: number, all: number): void } {
  const text = element("span", { role: "status" });
  const off = element("button", { type: "button" });
  const more = element("button", { type: "button" });
  off.onclick = goTo.firstOff;
  more.onclick = goTo.result;
  const root = element("div", { class: "bar" }, text, off, more);
  return {
    root,
    show({ checked, refused, isChecking }, filled, all) {
      const parts = checked?.parts ?? null;
      const isOff = checked?.result?.["passed"] === false || refused !== null;
      root.classList.toggle("busy", isChecking);
      off.textContent = say("first_off");
      more.textContent = say("to_result");
      off.hidden = parts === null || !isOff;
      more.hidden = !isOff;
      if (parts === null) text.textContent = say("filled", { filled, all });
      else text.innerHTML = parts.counts;
    },
  };
}
