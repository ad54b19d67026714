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

/** Their notes in Spanish. */
const SPANISH_NOTES: Record<string, string> = {
  "dyad-prp": "Como se dibuja en la pizarra. El perno C une las correderas 2 y 3: la 2 desliza sobre el eslabón 1, cuyo movimiento se conoce por entero; la 3, en una guía fija.",
  "dyad-rpp": "Como se dibuja en la pizarra: un yugo escocés. La corredera 2, articulada en B a una manivela, desliza en el yugo 3, que desliza sobre el bastidor.",
  "dyad-rpr": "Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento de los pernos exteriores B y D. El plano de aceleraciones tiene un término de Coriolis.",
  "dyad-rrp": "Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento del perno exterior B. La guía es fija.",
  "dyad-rrr": "Como se dibuja en la pizarra: «points» da cada coordenada, «known» el movimiento de los pernos exteriores B y D. Los eslabones 1 y 4 son los vecinos, dibujados como tocones.",
  "five-bar": "Dos grados de libertad y por eso dos accionamientos: las manivelas 1 y 4 mueven el punto C, cada una con su ángulo, su omega y su alpha.",
  "four-bar": "La manivela 1 mueve el balancín 3 por medio de la biela 2. Los puntos nombrados en dos eslabones son articulaciones entre ellos.",
  "fourth-class": "Los eslabones 2 y 4 están unidos por los eslabones 3 y 5, que forman el contorno cerrado C-D-F-G. Los planos necesitan un punto especial (de Assur) del eslabón 3 o 5.",
  "hydraulic-boom": "El cilindro 2 y el vástago 3 son un eslabón entre los pernos A y C cuya longitud cambia el accionamiento: giran juntos, y con la pluma forman una díada.",
  "platform-3rrr": "Tres grados de libertad, tres accionamientos: las manivelas 1, 2, 3 colocan y giran la plataforma 7 por las patas 4, 5, 6. Plataforma y patas son un grupo de tercera clase.",
  "slider-crank": "La manivela 1 mueve la corredera 3 por medio de la biela 2.",
  "slotted-lever": "La manivela 1 gira uniformemente; su perno B lleva la corredera 2, que desliza en la palanca oscilante 3. El plano de aceleraciones tiene un término de Coriolis.",
  "stephenson-3": "El punto E de la biela del cuadrilátero A-B-C-D mueve el balancín 5 por el eslabón 4: dos díadas que se resuelven una tras otra.",
  "third-class": "El eslabón ternario 3 cuelga de tres patas: 2 del perno de la manivela, 4 y 5 del bastidor. Ninguna díada se puede resolver primero: los planos necesitan un punto especial (de Assur) del eslabón 3.",
  "toggle-press": "La manivela 1 y la biela 2 estiran los eslabones 3 y 4 de la rodillera, que empujan el carro 5 hacia abajo: despacio y con fuerza cerca del final. C es un perno por tres eslabones.",
  "watt-1": "Un cuadrilátero A-B-C-D cuya biela 2 y cuyo balancín 3 llevan el segundo lazo C-E-G-F: dos díadas que se resuelven una tras otra.",
  "whitworth": "La manivela 1 gira uniformemente; la corredera 2 en su perno hace girar del todo la palanca ranurada 3; la biela 4 mueve el carro 5.",
};

/** A scene's note, in the page's language where the scene has that of a starting scene. */
export function noteOf(note: string, kinds: Kind[], language: Language): string {
  if (language !== "es") return note;
  const kind = kinds.find(({ text }) => text.includes(JSON.stringify(note)));
  return (kind === undefined ? undefined : SPANISH_NOTES[kind.name]) ?? note;
}

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
