import { exercise } from "../../sentences.ts";
import { speaker } from "../../words.ts";

export type Saying = keyof typeof exercise.en;
export const say = speaker(exercise);
