import { speaker, type Saying as Of } from "../words.ts";

export type Saying = Of<"build">;
export const say = speaker("build");
