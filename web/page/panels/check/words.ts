import { speaker, type Saying as Of } from "../../words.ts";

export type Saying = Of<"check">;
export const say = speaker("check");
