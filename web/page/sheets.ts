/** The sheets, as the page speaks of them. What else is known of them is told by the engine: a further one has its words in src/words/*.ftl. */
import { SHEETS, type Panel } from "./engine/types.ts";
import { sheets } from "./sentences.ts";
import { speaker } from "./words.ts";

/** A sheet by the word that files have for it. */
export type Sheet = Panel;

/** The sheets that are drawn from a pole. */
export const PLANS: Sheet[] = SHEETS.filter(({ isPlan }) => isPlan).map(({ key }) => key);

/** The sheets on which a hand draws and of whose points it gives the places: the plans, and the figure of instant centres. */
export const DRAWN_ON: Sheet[] = SHEETS.filter(({ hasPlaces }) => hasPlaces).map(({ key }) => key);

/** The key of a sheet's scale in scenes and forms. */
export type Scale = (typeof SHEETS)[number]["scale"];

/** How a sheet is spoken of: on a button; as what a scale is of; as a panel; within a sentence; as a heading; over what is read from it. */
type Speech = "short" | "scaled" | "panel" | "name" | "title" | "from";

const say = speaker(sheets);

/** A sheet in words. */
export function called(sheet: Sheet, how: Speech): string {
  return say(`${sheet}_${how}`);
}

/** The key of a sheet's scale. */
export function scaleOf(sheet: Sheet): Scale {
  return SHEETS.find(({ key }) => key === sheet)!.scale;
}
