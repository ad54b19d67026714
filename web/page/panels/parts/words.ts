import { speaker, type Words } from "../../words.ts";

type Key = "needed" | "unread" | "least" | "nameless" | "pin_point" | "pin_length" | "unreadable" | "mend" | "more";

const WORDS: Words<Key> = {
  en: {
    needed: "A number is needed here.",
    unread: "Not a number. Type 60, 2.5, 1/3 or 2*pi.",
    least: "At least {least}.",
    nameless: "A name is needed.",
    pin_point: "Hold {name} while shaping",
    pin_length: "Hold length {name} while shaping",
    unreadable: "The scene’s text has a mistake, so the form waits. Mend it in the text, or undo.",
    mend: "Show in the text",
    more: "{title}: all of it",
  },
  es: {
    needed: "Aquí hace falta un número.",
    unread: "No es un número. Escriba 60, 2,5, 1/3 o 2*pi.",
    least: "Al menos {least}.",
    nameless: "Hace falta un nombre.",
    pin_point: "Sujetar {name} al dar forma",
    pin_length: "Sujetar la longitud {name} al dar forma",
    unreadable: "El texto de la escena tiene un error y el formulario espera. Corríjalo en el texto o deshaga.",
    mend: "Mostrar en el texto",
    more: "{title}: todo",
  },
};

export const say = speaker(WORDS);
