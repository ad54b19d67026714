import { mechanism } from "../../sentences.ts";
import { speaker } from "../../words.ts";

export const say = speaker(mechanism);
