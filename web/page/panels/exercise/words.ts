import { speaker, type Saying as Of } from "../../words.ts";

export type Saying = Of<"exercise">;
export const say = speaker("exercise");
