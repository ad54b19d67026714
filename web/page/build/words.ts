import { build } from "../sentences.ts";
import { speaker } from "../words.ts";

export type Saying = keyof typeof build.en;
export const say = speaker(build);
