import type { PhotoRead, PhotoRefused } from "../../../engine/types.ts";
import { shownNumber } from "../../../number.ts";
import { language } from "../../../words.ts";
import { say } from "./words.ts";

/** Why a photograph is of no use, and what to do. */
export interface Why {
  message: string;
  hint: string;
}

function ofPicture({ why, number: count, message, hint }: PhotoRefused): Why {
  const shown = { number: shownNumber(Number(count.toFixed(1)), language.value === "es") };
  switch (why) {
    case "few-markers":
      return { message: count === 0 ? say("few_none") : count === 1 ? say("few_one") : say("few_some", { number: count }), hint: say("few_hint") };
    case "not-even":
      return { message: say("not_even", shown), hint: say("flat_hint") };
    case "blurred":
      return { message: say("blurred", shown), hint: say("blurred_hint") };
    case "bent":
      return { message: say("bent_much", { number: Math.round(count) }), hint: say("flat_hint") };
    case "no-code":
      return { message: say("no_code"), hint: say("no_code_hint") };
    case "other-page":
      return { message: say("other_page"), hint: say("other_page_hint") };
    default:
      return { message, hint };
  }
}

/** Why what was read from a photograph is of no use; null where it is. */
export function refusedBy({ photo, refused }: PhotoRead): Why | null {
  if (refused !== null) return ofPicture(refused);
  if (photo === null) return { message: say("few_none"), hint: say("few_hint") };
  if (!photo.is_own) return { message: say("other_sheet", { number: photo.number, name: photo.name === "" ? say("nameless") : photo.name }), hint: say("other_sheet_hint") };
  return photo.plans.length === 0 ? { message: say("no_plan"), hint: say("no_plan_hint") } : null;
}
