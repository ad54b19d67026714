/** The sheets, as the page speaks of them. What else is known of them is told by the engine: a further one is a line of words here. */
import { SHEETS, type Panel } from "./engine/types.ts";
import { language } from "./words.ts";

/** A sheet by the word that files have for it. */
export type Sheet = Panel;

/** The sheets that are drawn from a pole. */
export const PLANS: Sheet[] = SHEETS.filter(({ isPlan }) => isPlan).map(({ key }) => key);

/** The key of a sheet's scale in scenes and forms. */
export type Scale = (typeof SHEETS)[number]["scale"];

/** How a sheet is spoken of: on a button; as what a scale is of; as a panel; within a sentence; as a heading; over what is read from it. */
type Speech = "short" | "scaled" | "panel" | "name" | "title" | "from";

const WORDS: Record<"en" | "es", Record<Sheet, Record<Speech, string>>> = {
  en: {
    scheme: { short: "Scheme", scaled: "Scheme", panel: "Scheme", name: "scheme", title: "Scheme", from: "On the scheme" },
    velocity: { short: "Velocity", scaled: "Velocity", panel: "Velocity plan", name: "velocity plan", title: "Velocity plan", from: "From the velocity plan" },
    acceleration: {
      short: "Acceleration",
      scaled: "Acceleration",
      panel: "Acceleration plan",
      name: "acceleration plan",
      title: "Acceleration plan",
      from: "From the acceleration plan",
    },
  },
  es: {
    scheme: { short: "Esquema", scaled: "Esquema", panel: "Esquema", name: "esquema", title: "Esquema", from: "En el esquema" },
    velocity: {
      short: "Velocidad",
      scaled: "Velocidades",
      panel: "Plan de velocidades",
      name: "plano de velocidades",
      title: "Plano de velocidades",
      from: "Del plano de velocidades",
    },
    acceleration: {
      short: "Aceleración",
      scaled: "Aceleraciones",
      panel: "Plan de aceleraciones",
      name: "plano de aceleraciones",
      title: "Plano de aceleraciones",
      from: "Del plano de aceleraciones",
    },
  },
};

/** A sheet in words. */
export function called(sheet: Sheet, how: Speech): string {
  return WORDS[language.value][sheet][how];
}

/** The key of a sheet's scale. */
export function scaleOf(sheet: Sheet): Scale {
  return SHEETS.find(({ key }) => key === sheet)!.scale;
}
