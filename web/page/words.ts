import { signal } from "./state/signal.ts";

/** The languages of the page; a scene's `figure.language` chooses. */
export const LANGUAGES = ["en", "es"] as const;
export type Language = (typeof LANGUAGES)[number];

/** The page's language. */
export const language = signal<Language>("en");

/** What a part of the page says, in all languages: a missing sentence does not compile. */
export type Words<Key extends string> = Record<Language, Record<Key, string>>;

/** Looks a sentence up in the page's language; `{name}` in it is filled. */
export function speaker<Key extends string>(words: Words<Key>): (key: Key, blanks?: Record<string, string | number>) => string {
  return (key, blanks = {}) =>
    words[language.value][key].replace(/\{(\w+)\}/g, (whole, name: string) => String(blanks[name] ?? whole));
}
