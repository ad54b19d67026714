import { LANGUAGES } from "./sentences.ts";
import { signal } from "./state/signal.ts";

/** The languages of the page. That of a figure is its own: `figure.language` of its scene. */
export type Language = (typeof LANGUAGES)[number];

/** A text with blanks as `{name}`; or texts and choices: by the value of a blank, or by the form that words have beside it if it is a number. */
export type Sentence = string | readonly (string | { readonly by: string; readonly forms: Readonly<Record<string, Sentence>> })[];

/** What stands in the blanks. */
type Blanks = Record<string, string | number>;

/** The page's language. */
export const language = signal<Language>("en");

/** The language to begin with: the one that the person chose before, else the first of the browser's that the page has. */
export function usual(chosen: string | null): Language {
  const wanted = [chosen ?? "", ...navigator.languages].map((name) => name.slice(0, 2).toLowerCase());
  return wanted.flatMap((name) => LANGUAGES.filter((known) => known === name))[0] ?? "en";
}

/** A sentence of this language with its blanks filled. */
function filled(sentence: Sentence, blanks: Blanks, spoken: Language): string {
  if (typeof sentence === "string") return sentence.replace(/\{(\w+)\}/g, (whole, name: string) => String(blanks[name] ?? whole));
  const piece = (piece: Sentence | { by: string; forms: Readonly<Record<string, Sentence>> }): string => {
    if (typeof piece === "string" || !("by" in piece)) return filled(piece, blanks, spoken);
    const value = String(blanks[piece.by]);
    const form = piece.forms[value] ?? piece.forms[new Intl.PluralRules(spoken).select(Number(value))] ?? piece.forms["other"] ?? "";
    return filled(form, blanks, spoken);
  };
  return sentence.map(piece).join("");
}

/** What a part of the page says, in the page's language; `{name}` in it is filled. Sentences stand in src/words/*.ftl: one that is missing does not compile. */
export function speaker<Key extends string>(words: Record<Language, Record<Key, Sentence>>): (key: Key, blanks?: Blanks) => string {
  return (key, blanks = {}) => filled(words[language.value][key], blanks, language.value);
}
