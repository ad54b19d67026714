import { say as drawn } from "../../board/words.ts";
import { element } from "../../dom/element.ts";
import type { BoardUse } from "../../state/address.ts";
import { say } from "./words.ts";

/** How students draw: on paper, or on the board, with what is told of it and what the hand is helped with. */
const USES = [null, ["practice", false], ["practice", true], ["exam", false], ["demonstration", false]] as const;
const SNAPS = ["all", "points", "none"] as const;

export function boardChoice(changed: () => void): { root: HTMLElement; now(): BoardUse | null } {
  const words = (index: number): string => say(`board_${(["paper", "practice", "at_once", "exam", "demonstration"] as const)[index]!}`);
  const use = element("select", { "aria-label": drawn("title") }, ...USES.map((_, index) => element("option", { value: index }, words(index))));
  const snap = element("select", { "aria-label": say("board_snap") }, ...SNAPS.map((value) => element("option", { value }, say(`board_snap_${value}`))));
  snap.hidden = true;
  use.onchange = () => {
    snap.hidden = use.value === "0" || use.value === "4";
    changed();
  };
  snap.onchange = changed;
  return {
    root: element("span", { class: "board-choice" }, use, snap),
    now() {
      const chosen = USES[Number(use.value)];
      return chosen == null ? null : { mode: chosen[0], at_once: chosen[1], snap: SNAPS.find((value) => value === snap.value) ?? "all" };
    },
  };
}
