import { photo } from "../../../sentences.ts";
import { speaker } from "../../../words.ts";

export type Saying = keyof typeof photo.en;
export const say = speaker(photo);
