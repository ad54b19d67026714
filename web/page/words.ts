import { signal } from "./state/signal.ts";

/** The languages of the page. That of a figure is its own: `figure.language` of its scene. */
const LANGUAGES = ["en", "es"] as const;
export type Language = (typeof LANGUAGES)[number];

/** The page's language. */
export const language = signal<Language>("en");

/** The language to begin with: the one that the person chose before, else the first of the browser's that the page has. */
export function usual(chosen: string | null): Language {
  const wanted = [chosen ?? "", ...navigator.languages].map((name) => name.slice(0, 2).toLowerCase());
  return wanted.flatMap((name) => LANGUAGES.filter((known) => known === name))[0] ?? "en";
}

/** What a part of the page says, in all languages: a missing sentence does not compile. */
export type Words<Key extends string> = Record<Language, Record<Key, string>>;

/** Looks a sentence up in the page's language; `{name}` in it is filled. */
export function speaker<Key extends string>(words: Words<Key>): (key: Key, blanks?: Record<string, string | number>) => string {
  return (key, blanks = {}) =>
    words[language.value][key].replace(/\{(\w+)\}/g, (whole, name: string) => String(blanks[name] ?? whole));
}
