import type { App } from "../app.ts";
import { drawingOf } from "../board/file.ts";
import { takesText } from "../dom/find.ts";
import { textOf } from "../files/open.ts";
import { notice } from "./messages.ts";
import { say } from "./words.ts";

/** Endings of files that {@link openFile} reads. */
export const READABLE = ".json,.csv,.txt,.tsv,application/json,text/csv";

/** A key that a form, or a marking scheme, has and a scene has not. */
const OF_CHECK = /"kinegon_(measured|marks)"\s*:/;

/** Whether a text is for the panel *Check*: a form, also as a table, or a marking scheme. */
function isForCheck(name: string, text: string): boolean {
  return OF_CHECK.test(text) || (/\.(csv|tsv|txt)$/i.test(name) && !/^\s*\{/.test(text));
}

/** Takes a text that somebody brings: a scene in place of the present one; what is for the check beside it; a drawing on the board. */
function take(app: App, name: string, text: string): void {
  if (isForCheck(name, text)) {
    app.brought.set({ name, text });
    app.show("check");
    return;
  }
  if (drawingOf(text) !== null) {
    app.history.draw(text);
    return app.drawing.set(true);
  }
  app.open(text);
  if (name !== "") app.tell(say("opened_file", { name }));
}

/** A file with its text; null, and said, where it cannot be read. */
export async function readFile(file: File): Promise<{ name: string; text: string } | null> {
  const { name } = file;
  try {
    const text = await textOf(file);
    if (text !== null) return { name, text };
    notice(say("file_too_large", { name }));
  } catch {
    // A folder, or a file that has gone.
    notice(say("unread_file", { name }));
  }
  return null;
}

/** Pictures, also those of telephones whose kind a browser does not know. */
const PICTURE = /\.(jpe?g|png|webp|avif|heic|heif)$/i;

/** Opens a file that somebody brings; none where none is chosen. A picture is a photograph of a drawing. */
export async function openFile(app: App, file: File | null): Promise<void> {
  if (file !== null && (/^image\/(?!svg)/.test(file.type) || PICTURE.test(file.name))) {
    app.photographed.set(file);
    return app.show("check");
  }
  const read = file === null ? null : await readFile(file);
  if (read !== null) take(app, read.name, read.text);
}

/** What is dropped on the page, or pasted outside of a box of text, is opened. */
export function dropped(app: App): void {
  const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
  document.addEventListener("dragover", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  document.addEventListener("dragleave", (event) => event.relatedTarget === null && document.body.classList.remove("dropping"));
  // Before the editor, which would put the file's text into its own.
  document.addEventListener("drop", (event) => {
    document.body.classList.remove("dropping");
    const file = event.dataTransfer?.files[0];
    if (file === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    void openFile(app, file);
  }, { capture: true });
  document.addEventListener("paste", (event) => {
    if (event.defaultPrevented || takesText(event.target)) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    // A spreadsheet brings a picture of its cells beside their text.
    const picture = text === "" ? event.clipboardData?.files[0] : undefined;
    if (picture !== undefined) return void openFile(app, picture);
    if (!/^\s*\{/.test(text)) return;
    event.preventDefault();
    take(app, "", text);
  });
}
