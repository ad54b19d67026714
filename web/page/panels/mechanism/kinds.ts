import type { Kind } from "../../engine/types.ts";
import type { Language } from "../../words.ts";

type Group = "groups_bars" | "groups_more" | "groups_drives" | "groups_class" | "groups_drawn" | "groups_paper";

/** The starting scenes by group. */
export const GROUPS: Record<Group, string[]> = {
  groups_bars: ["four-bar", "slider-crank", "slotted-lever", "hydraulic-boom"],
  groups_more: ["watt-1", "stephenson-3", "whitworth", "toggle-press"],
  groups_drives: ["five-bar", "platform-3rrr"],
  groups_class: ["third-class", "fourth-class"],
  groups_paper: ["paper-figure-1", "paper-figure-2"],
  groups_drawn: ["dyad-rrr", "dyad-rrp", "dyad-rpr", "dyad-prp", "dyad-rpp"],
};

/** Their titles in Spanish; the files are English. */
const SPANISH: Record<string, string> = {
  "four-bar": "Cuadrilátero articulado",
  "slider-crank": "Biela-manivela descentrado",
  "slotted-lever": "Manivela y palanca ranurada (retorno rápido)",
  "hydraulic-boom": "Pluma con cilindro hidráulico",
  "watt-1": "Watt I, seis eslabones",
  "stephenson-3": "Stephenson III, seis eslabones",
  whitworth: "Retorno rápido de Whitworth",
  "toggle-press": "Prensa de rodillera",
  "five-bar": "Cinco eslabones con dos accionamientos",
  "platform-3rrr": "Plataforma 3-RRR",
  "third-class": "Grupo de tercera clase",
  "fourth-class": "Grupo de cuarta clase",
  "paper-figure-1": "Quintero et al. (2011), figura 1",
  "paper-figure-2": "Quintero et al. (2011), figura 2",
  "dyad-rrr": "Díada RRR: dos eslabones, tres pernos",
  "dyad-rrp": "Díada RRP: biela y corredera",
  "dyad-rpr": "Díada RPR: corredera en la ranura de una palanca",
  "dyad-prp": "Díada PRP: dos correderas en un perno",
  "dyad-rpp": "Díada RPP: corredera en la ranura de otra",
};

/** The title of a starting scene. */
export function titleOf(kind: Kind, language: Language): string {
  return (language === "es" ? SPANISH[kind.name] : undefined) ?? kind.title ?? kind.name;
}

/** A scene without links, to begin with. */
export const EMPTY = `{
  "kinegon": 1,
  "units": { "length": "mm", "time": "s" },
  "ground": {},
  "links": {}
}
`;
