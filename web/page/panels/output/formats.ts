import type { App } from "../../app.ts";
import type { FileRequest } from "../../engine/types.ts";
import { goodText } from "../../state/solving.ts";
import { png } from "./png.ts";

/** What can be saved: what the engine writes, and pictures of pixels, which the browser makes. */
export type FileFormat = Exclude<FileRequest["format"], "outlines"> | "png";

/** A file of the last good scene. */
export async function fileOf(app: App, format: FileFormat, of: FileRequest["of"]): Promise<Uint8Array> {
  const good = await goodText(app);
  return format === "png" ? png(await app.engine.file(good, { format: "outlines", of })) : app.engine.file(good, { format, of });
}

/** Forms of a picture, with their names for people. */
export const PICTURES = [["svg", "SVG"], ["pdf", "PDF"], ["png", "PNG"], ["tikz", "TikZ"]] as const;

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
