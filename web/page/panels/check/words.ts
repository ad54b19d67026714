import { check } from "../../sentences.ts";
import { speaker } from "../../words.ts";

export type Saying = keyof typeof check.en;
export const say = speaker(check);
