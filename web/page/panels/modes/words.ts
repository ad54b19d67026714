import { modes } from "../../sentences.ts";
import { speaker } from "../../words.ts";

export const say = speaker(modes);
