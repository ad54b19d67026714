import { speaker } from "../page/words.ts";

/** What the component says besides what the page says, too. */
export const say = speaker({
  en: {
    none: "The plan has no scene: give it the address of one in src, or write one between its tags in a script of the type application/json.",
    unread: "{src} could not be read ({why}).",
    from_file: "A page that is opened from a file may not read others: write the scene between the tags.",
  },
  es: {
    none: "El plano no tiene escena: dé su dirección en src, o escríbala entre las etiquetas en un script de tipo application/json.",
    unread: "No se pudo leer {src} ({why}).",
    from_file: "Una página abierta desde un archivo no puede leer otros: escriba la escena entre las etiquetas.",
  },
});
