import type { PhotoRead } from "../../../engine/types.ts";
import { say } from "./words.ts";

/** Why a photograph is of no use, and what to do. */
export interface Why {
  message: string;
  hint: string;
}

/** What the engine says, as a sentence. */
const sentence = (said: string): string => `${said.charAt(0).toUpperCase()}${said.slice(1)}.`;

/** Why what was read from a photograph is of no use; null where it is. */
export function refusedBy({ photo, refused }: PhotoRead): Why | null {
  if (refused !== null) return { message: sentence(refused.message), hint: sentence(refused.hint) };
  if (photo === null) return null;
  if (!photo.is_own) return { message: say("other_sheet", { number: photo.number, name: photo.name === "" ? say("nameless") : photo.name }), hint: say("other_sheet_hint") };
  return photo.plans.length === 0 ? { message: say("no_plan"), hint: say("no_plan_hint") } : null;
}
