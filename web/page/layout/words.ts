import { speaker, type Saying as Of } from "../words.ts";

export type Saying = Of<"layout">;
export const say = speaker("layout");
