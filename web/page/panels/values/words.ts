import { speaker, type Words } from "../../words.ts";

type Key =
  | "find"
  | "digits"
  | "certain"
  | "few"
  | "copy"
  | "save"
  | "copied"
  | "not_copied"
  | "quantity"
  | "value"
  | "unit"
  | "error"
  | "count"
  | "none"
  | "about"
  | "about_few"
  | "groups"
  | "warnings"
  | "hidden"
  | "reveal";

const WORDS: Words<Key> = {
  en: {
    find: "Find a quantity",
    digits: "Digits",
    certain: "all certain digits",
    few: "{count} digits",
    copy: "Copy",
    save: "CSV",
    copied: "The table is on the clipboard.",
    not_copied: "This browser does not let the page use the clipboard. Save the table as CSV.",
    quantity: "Quantity",
    value: "Value",
    unit: "Unit",
    error: "±",
    count: "{count} of {all} quantities",
    none: "No quantity has this in its name.",
    about: "Every digit shown is certain; ± is how far the value can be from the scene’s true one.",
    about_few: "Rounded. “All certain digits” shows every digit that is certain, and how far the value can be from the scene’s true one.",
    groups: "Assur groups",
    warnings: "Warnings",
    hidden: "This page was opened with a student’s link. The values here are what the sheet asks for.",
    reveal: "Show them all the same",
  },
  es: {
    find: "Buscar una magnitud",
    digits: "Cifras",
    certain: "cifras seguras",
    few: "{count} cifras",
    copy: "Copiar",
    save: "CSV",
    copied: "La tabla está en el portapapeles.",
    not_copied: "Este navegador no deja que la página use el portapapeles. Guarde la tabla como CSV.",
    quantity: "Magnitud",
    value: "Valor",
    unit: "Unidad",
    error: "±",
    count: "{count} de {all} magnitudes",
    none: "Ninguna magnitud tiene esto en su nombre.",
    about: "Toda cifra que se muestra es segura; ± dice cuánto puede distar el valor del verdadero de la escena.",
    about_few: "Redondeado. «Cifras seguras» muestra toda cifra segura y cuánto puede distar el valor del verdadero de la escena.",
    groups: "Grupos de Assur",
    warnings: "Advertencias",
    hidden: "Esta página se abrió con un enlace para estudiantes. Los valores de aquí son los que pide la hoja.",
    reveal: "Mostrarlos de todos modos",
  },
};

/** The panel's sentences. */
export const say = speaker(WORDS);
