import type { App } from "../../app.ts";
import type { FileRequest } from "../../engine/types.ts";
import { element } from "./element.ts";
import { png } from "./png.ts";

/** What can be saved: what the engine writes, and pictures of pixels, which the browser makes. */
export type FileFormat = Exclude<FileRequest["format"], "outlines"> | "png";

/** A file of the last good scene. */
export async function fileOf(app: App, format: FileFormat, of: FileRequest["of"]): Promise<Uint8Array> {
  const { good } = app.solved.value;
  return format === "png" ? png(await app.engine.file(good, { format: "outlines", of })) : app.engine.file(good, { format, of });
}

/** Kinds of files by their formats. */
export const TYPES: Record<FileFormat, string> = {
  svg: "image/svg+xml",
  png: "image/png",
  pdf: "application/pdf",
  tikz: "text/x-tex",
  csv: "text/csv",
  json: "application/json",
  steps: "text/plain",
};

/** Endings of files by their formats. */
export const ENDINGS: Record<FileFormat, string> = {
  svg: "svg",
  png: "png",
  pdf: "pdf",
  tikz: "tex",
  csv: "csv",
  json: "json",
  steps: "txt",
};

/** Names that Windows keeps for devices. */
const DEVICES = /^(con|prn|aux|nul|com\d|lpt\d)$/;

/** The longest name of a file made of a title, without its ending. */
const LONGEST = 60;

/** A title as the name of a file on any computer, without an ending: letters, digits and hyphens. */
export function fileName(title: string): string {
  const words = title.normalize("NFC").toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-");
  const name = [...words].slice(0, LONGEST).join("").replace(/^-+|-+$/g, "");
  return name === "" || DEVICES.test(name) ? ["kinegon", name].filter(Boolean).join("-") : name;
}

/** Lets the browser save a file. */
export function download(name: string, contents: Uint8Array | string, type: string): void {
  const address = URL.createObjectURL(new Blob([contents as BlobPart], { type }));
  const link = element("a", { href: address, download: name, hidden: true });
  document.body.append(link);
  link.click();
  link.remove();
  // A browser may begin reading only after it has asked where to.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Puts a text on the clipboard; tells whether that was possible. */
export async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copiedBySelection(text);
  }
}

/** The older way, for pages opened where the clipboard is closed. */
function copiedBySelection(text: string): boolean {
  const area = element("textarea", { class: "off-screen", "aria-hidden": "true" });
  area.value = text;
  document.body.append(area);
  const before = document.activeElement;
  area.select();
  const done = document.execCommand("copy");
  area.remove();
  if (before instanceof HTMLElement) before.focus();
  return done;
}
