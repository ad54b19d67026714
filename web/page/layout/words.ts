import { layout } from "../sentences.ts";
import { speaker } from "../words.ts";

export type Saying = keyof typeof layout.en;
export const say = speaker(layout);
