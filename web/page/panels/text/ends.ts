/** How a text ends its lines and begins: the editor knows one way only, the file keeps its own. */
export interface Ends {
  mark: string;
  newline: string;
}

export function endsOf(text: string): Ends {
  return { mark: text.startsWith("\uFEFF") ? "\uFEFF" : "", newline: text.includes("\r\n") ? "\r\n" : "\n" };
}

/** The text as the editor has it. */
export function edited(text: string): string {
  return text.replace(/^\uFEFF/, "").replace(/\r\n?/g, "\n");
}

/** The editor's text as the file has it. */
export function filed(text: string, { mark, newline }: Ends): string {
  return mark + (newline === "\n" ? text : text.replaceAll("\n", newline));
}

/** A place of the file's text in the editor's. */
export function placed(text: string, place: number): number {
  return edited(text.slice(0, place)).length;
}
