import { component } from "../page/sentences.ts";
import { speaker } from "../page/words.ts";

/** What the component says besides what the page says, too. */
export const say = speaker(component);
