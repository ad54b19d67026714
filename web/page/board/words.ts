import { board } from "../sentences.ts";
import { speaker } from "../words.ts";

export type Saying = keyof typeof board.en;
export const say = speaker(board);
