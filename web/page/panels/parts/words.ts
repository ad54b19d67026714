import { parts } from "../../sentences.ts";
import { speaker } from "../../words.ts";

export const say = speaker(parts);
