import { speaker, type Words } from "../../words.ts";

type Key =
  | "what"
  | "curves"
  | "hodograph"
  | "path"
  | "choose"
  | "clear"
  | "beyond"
  | "none"
  | "drawn"
  | "waits"
  | "save"
  | "table"
  | "events"
  | "no_events";

const WORDS: Words<Key> = {
  en: {
    what: "What is drawn",
    curves: "Curves",
    hodograph: "Hodographs",
    path: "Paths",
    choose: "Choose",
    clear: "None",
    beyond: "Beyond the limits of the drive, too, dashed",
    none: "Choose at least one.",
    drawn: "This scene gives its points as they are drawn. It cannot be moved, so there is nothing over a cycle.",
    waits: "Drawing …",
    save: "Save as {format}",
    table: "Table as CSV",
    events: "Special positions",
    no_events: "None over this range.",
  },
  es: {
    what: "Qué se dibuja",
    curves: "Curvas",
    hodograph: "Hodógrafas",
    path: "Trayectorias",
    choose: "Elegir",
    clear: "Ninguna",
    beyond: "También más allá de los límites motrices, a trazos",
    none: "Elija al menos una.",
    drawn: "Esta escena da sus puntos tal como están dibujados. No puede moverse; no hay nada a lo largo de un ciclo.",
    waits: "Dibujando …",
    save: "Guardar como {format}",
    table: "Tabla como CSV",
    events: "Posiciones especiales",
    no_events: "Ninguna en este intervalo.",
  },
};

/** The panel's sentences. */
export const say = speaker(WORDS);
