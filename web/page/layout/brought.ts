import type { App } from "../app.ts";
import type { HandedIn } from "../board/class.ts";
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
  const isDrawing = drawingOf(text) !== null;
  if (app.exam.value && !isDrawing) return app.tell(say("exam_open"));
  if (isForCheck(name, text)) {
    app.brought.set({ name, text });
    app.show("check");
    return;
  }
  if (isDrawing) {
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
    if (app.exam.value) return app.tell(say("exam_open"));
    app.photographed.set(file);
    return app.show("check");
  }
  const read = file === null ? null : await readFile(file);
  if (read !== null) take(app, read.name, read.text);
}

/** Something dropped: a file, or a folder with what is in it. Browsers read folders in two ways, of which the older fails on pages that are files. */
interface Brought {
  handle: Promise<FileSystemHandle | null> | undefined;
  entry: FileSystemEntry | null;
  file: File | null;
}

/** What is dropped, taken while it can be had. */
function broughtBy(items: DataTransferItemList): Brought[] {
  return [...items].filter(({ kind }) => kind === "file").map((item) => ({
    handle: (item as DataTransferItem & { getAsFileSystemHandle?(): Promise<FileSystemHandle | null> }).getAsFileSystemHandle?.(),
    entry: item.webkitGetAsEntry(),
    file: item.getAsFile(),
  }));
}

async function inFolder(folder: FileSystemDirectoryHandle): Promise<File[]> {
  const found: File[] = [];
  for await (const each of (folder as FileSystemDirectoryHandle & { values(): AsyncIterable<FileSystemHandle> }).values()) {
    found.push(...(each.kind === "file" ? [await (each as FileSystemFileHandle).getFile()] : await inFolder(each as FileSystemDirectoryHandle)));
  }
  return found;
}

async function inEntry(entry: FileSystemEntry): Promise<File[]> {
  if (entry.isFile) return [await new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed))];
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: File[] = [];
  // A folder is read in parts.
  for (let part: FileSystemEntry[]; (part = await new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed))).length > 0; ) {
    for (const each of part) found.push(...(await inEntry(each)));
  }
  return found;
}

/** The files of what is dropped, also of folders and those in them. */
async function filesOf(all: readonly Brought[]): Promise<File[]> {
  const found: File[] = [];
  for (const { handle, entry, file } of all) {
    const isFolder = entry?.isDirectory === true;
    const known = isFolder ? await handle?.catch(() => null) : null;
    if (known != null) found.push(...(await inFolder(known as FileSystemDirectoryHandle)));
    else if (isFolder) found.push(...(await inEntry(entry)));
    else if (file !== null) found.push(file);
  }
  return found;
}

/** Takes the drawings of a class; of other files the first is opened, and it is said that the others are not. */
async function takeAll(app: App, files: readonly File[]): Promise<void> {
  const drawings: HandedIn[] = [];
  const forms: File[] = [];
  for (const file of files.toSorted((a, b) => a.name.localeCompare(b.name))) {
    const text = /\.(json|csv|tsv|txt)$/i.test(file.name) ? await textOf(file) : null;
    if (text === null) continue;
    if (drawingOf(text) !== null) drawings.push({ name: file.name, text });
    else if (isForCheck(file.name, text)) forms.push(file);
  }
  if (drawings.length > 0) {
    app.handed.set(drawings);
    app.drawing.set(true);
    if (forms.length > 0) notice(say("forms_left"));
    return;
  }
  const first = forms[0] ?? files[0] ?? null;
  await openFile(app, first);
  if (first !== null && forms.length > 1) notice(say("forms_first", { name: first.name, count: forms.length }));
  else if (first !== null && files.length > 1) notice(say("files_first", { name: first.name, count: files.length }));
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
    const { files, items } = event.dataTransfer ?? {};
    const file = files?.[0];
    if (file === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const all = items === undefined ? [] : broughtBy(items);
    // A student's page judges the own drawing alone.
    const isClass = !app.student.value && (all.length > 1 || all[0]?.entry?.isDirectory === true);
    void (isClass ? filesOf(all).then((files) => takeAll(app, files)).catch(() => notice(say("unread_file", { name: file.name }))) : openFile(app, file));
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
