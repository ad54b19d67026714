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
/** A part of the page in all languages, which all have the same keys. */
function part(name) {
  const keys = (language) => Object.keys(all[language][name] ?? {}).sort().join(" ");
  const spoken = LANGUAGES.filter((language) => !(TRANSLATIONS.includes(name) && language === "en"));
  for (const language of spoken) if (keys(language) !== keys("es")) throw new Error(`${language}.ftl has not the keys page-${name}-… that es.ftl has`);
  return Object.fromEntries(LANGUAGES.map((language) => [language, all[language][name] ?? {}]));
}

const json = (value) => JSON.stringify(value, null, 2);
const declared = Object.keys(all.es).map((name) => `export const ${name} = ${json(part(name))};\n`);
const written = `// What the page says, by its parts. Made from src/words/*.ftl by sentences.mjs: web/README.md says how.

export const LANGUAGES = ${JSON.stringify(LANGUAGES)} as const;

${declared.join("\n")}`;
if (!process.argv.includes("--check")) writeFileSync(output, written);
else if (readFileSync(output, "utf8") !== written) throw new Error("page/sentences.ts is not that of src/words: web/build --types");
