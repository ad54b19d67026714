// What the page says, from the catalogues of all languages: node sentences.mjs writes page/sentences.ts, with --check it compares.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { parse } from "@fluent/syntax";

const here = import.meta.dirname;
const output = join(here, "page/sentences.ts");
const LANGUAGES = ["en", "es", "de", "pt"];
/** What stands elsewhere in English: titles of the starting scenes, the words of CodeMirror. */
const TRANSLATIONS = ["kinds", "editor"];

/** A sentence as the page fills it: a text with blanks as `{name}`, or a list of such texts and choices (page/words.ts). */
function sentence(pattern, key) {
  const pieces = [];
  const add = (text) => (typeof pieces.at(-1) === "string" ? (pieces[pieces.length - 1] += text) : pieces.push(text));
  for (const element of pattern.elements) {
    const { type, expression } = element;
    if (type === "TextElement") add(element.value);
    else if (expression.type === "StringLiteral") add(expression.parse().value);
    else if (expression.type === "VariableReference") add(`{${expression.id.name}}`);
    else if (expression.type === "SelectExpression" && expression.selector.type === "VariableReference") {
      const named = expression.variants.map(({ key: form, value, default: other }) => [other ? "other" : (form.name ?? form.value), sentence(value, key)]);
      pieces.push({ by: expression.selector.id.name, forms: Object.fromEntries(named) });
    } else throw new Error(`${key}: in braces stand blanks, texts in quotes, and choices by a blank`);
  }
  return pieces.length === 1 && typeof pieces[0] === "string" ? pieces[0] : pieces;
}

/** The page's sentences of a language, by parts of the page. */
function spoken(language) {
  const text = readFileSync(join(here, `../src/words/${language}.ftl`), "utf8");
  const parts = {};
  for (const entry of parse(text).body) {
    if (entry.type === "Junk") throw new Error(`${language}.ftl: ${entry.annotations[0]?.message}: ${entry.content}`);
    const [, part, key] = (entry.type === "Message" && entry.id.name.match(/^page-([a-z]+)-(.+)$/)) || [];
    if (part !== undefined) (parts[part] ??= {})[key] = sentence(entry.value, entry.id.name);
  }
  return parts;
}

const all = Object.fromEntries(LANGUAGES.map((language) => [language, spoken(language)]));
const only = (parts, kept) => Object.fromEntries(Object.entries(parts).filter(([part]) => TRANSLATIONS.includes(part) === kept));
const json = (value) => JSON.stringify(value, null, 2);
const written = `// What the page says. Made from src/words/*.ftl by sentences.mjs: web/README.md says how.
import type { Sentence } from "./words.ts";

const en = ${json(only(all.en, false))};

/** The sentences of a language, by part of the page. */
export type Spoken = { [Part in keyof typeof en]: Record<keyof (typeof en)[Part], Sentence> };

/** By language: all have all sentences. */
export const SENTENCES: Record<"${LANGUAGES.join('" | "')}", Spoken> = {
  en,
${LANGUAGES.slice(1).map((language) => `  ${language}: ${json(only(all[language], false))},\n`).join("")}};

/** What stands in English elsewhere: titles and notes of starting scenes, words of the editor. */
export const TRANSLATIONS: Record<keyof typeof SENTENCES, Record<"${TRANSLATIONS.join('" | "')}", Record<string, string>>> = ${json(
  Object.fromEntries(LANGUAGES.map((language) => [language, { ...Object.fromEntries(TRANSLATIONS.map((part) => [part, {}])), ...only(all[language], true) }])),
)};
`;
if (!process.argv.includes("--check")) writeFileSync(output, written);
else if (readFileSync(output, "utf8") !== written) throw new Error("page/sentences.ts is not that of src/words: web/build --types");
