/**
 * A drawing as the engine writes it, taken apart without a page: one element a line; groups have their opening and their end on lines of their own.
 */

/** What a line says: an element, and where it opens a group what is in that. */
export interface Draft {
  line: string;
  inner: Draft[] | null;
}

/** The tree of the lines; null where they are no tree. */
export function drafts(markup: string): Draft[] | null {
  const top: Draft[] = [];
  const open = [top];
  for (const line of markup.split("\n")) {
    if (line === "") continue;
    if (line === "</g>") open.pop();
    else {
      const isGroup = line.startsWith("<g") && line.lastIndexOf("<") === 0 && !line.endsWith("/>");
      const inner: Draft[] | null = isGroup ? [] : null;
      open.at(-1)?.push({ line, inner });
      if (inner !== null) open.push(inner);
    }
    if (open.length === 0) return null;
  }
  return open.length === 1 ? top : null;
}

/** By what a part is found again: its id, the style of a group, the kind and the words of anything else. */
export function keyOf(draft: Draft | undefined): string {
  if (draft === undefined) return "";
  const { line, inner } = draft;
  const id = / id="[^"]*"/.exec(line)?.[0];
  if (id !== undefined) return id;
  if (inner !== null) return line;
  return line.startsWith("<text") ? line.replace(/<[^>]*>/g, "") : (/^<\w+/.exec(line)?.[0] ?? "");
}

/** The markup of a draft. */
export const textOf = ({ line, inner }: Draft): string => (inner === null ? line : `${line}\n${inner.map((draft) => `${textOf(draft)}\n`).join("")}</g>`);

/** The tags of a line, and the words between them. */
export const piecesOf = (line: string): string[] => line.match(/<[^>]*>|[^<]+/g) ?? [];
