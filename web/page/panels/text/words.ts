import { speaker, type Words } from "../../words.ts";

type Key = "editor" | "good" | "go" | "help" | "long" | "lay_out";

const WORDS: Words<Key> = {
  en: {
    editor: "Text of the scene",
    good: "The text is a complete scene.",
    go: "Go there",
    long: "This text stands in a line that is too long to be shown.",
    lay_out: "Lay it out in lines",
    help: "This text is the whole document: a scene file of the program. Ctrl+Space offers keys, Ctrl+F searches, Esc then Tab leaves.",
  },
  es: {
    editor: "Texto de la escena",
    good: "El texto es una escena completa.",
    go: "Ir allí",
    long: "Este texto está en una línea demasiado larga para mostrarla.",
    lay_out: "Repartirlo en líneas",
    help: "Este texto es todo el documento: un archivo de escena del programa. Ctrl+Espacio ofrece claves, Ctrl+F busca, Esc y Tab sale.",
  },
};

export const say = speaker(WORDS);

/** What the editor itself says, in Spanish; English is its own. */
export const SPANISH: Record<string, string> = {
  Find: "Buscar",
  Replace: "Reemplazar",
  next: "siguiente",
  previous: "anterior",
  all: "todos",
  "match case": "mayúsculas",
  "by word": "palabra entera",
  regexp: "expresión regular",
  replace: "reemplazar",
  "replace all": "reemplazar todos",
  close: "cerrar",
  "current match": "coincidencia actual",
  "on line": "en la línea",
  "Fold line": "Plegar",
  "Unfold line": "Desplegar",
  "folded code": "texto plegado",
  unfold: "desplegar",
  Completions: "Propuestas",
  Diagnostics: "Mensajes",
  "No diagnostics": "Sin mensajes",
};
