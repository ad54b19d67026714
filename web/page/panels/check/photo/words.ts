import { speaker, type Saying as Of } from "../../../words.ts";

export type Saying = Of<"photo">;
export const say = speaker("photo");
