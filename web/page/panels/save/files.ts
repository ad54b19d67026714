import type { App } from "../../app.ts";
import type { FileRequest } from "../../engine/types.ts";
import { said } from "../output/current.ts";
import { download, ENDINGS, type FileFormat, fileName, fileOf, TYPES } from "../output/download.ts";
import { say } from "./words.ts";

/** Forms of a picture, with their names for people. */
export const PICTURES = [["svg", "SVG"], ["pdf", "PDF"], ["png", "PNG"], ["tikz", "TikZ"]] as const;

/** A name for files of the present scene, without an ending. */
export function stem(app: App): string {
  return fileName(app.solved.value.opened?.title ?? "");
}

/** Saves a file of the last good scene; `part` stands in its name. */
export async function saveFile(app: App, request: { format: FileFormat; of: FileRequest["of"] }, part: string): Promise<void> {
  const name = [stem(app), part].filter(Boolean).join("-");
  await orTell(app, async () => {
    const isPicture = PICTURES.some(([format]) => format === request.format);
    const count = isPicture ? await pagesOf(app, request.of) : 1;
    for (let number = 1; number <= count; number += 1) {
      const of = number === 1 ? request.of : { worksheet: number };
      const bytes = await fileOf(app, request.format, of);
      saved(app, `${name}${number === 1 ? "" : `-${number}`}.${ENDINGS[request.format]}`, bytes, TYPES[request.format]);
    }
  });
}

/** How many sheets of paper a drawing takes: the table of a work sheet may stand on a second one. */
export async function pagesOf(app: App, of: FileRequest["of"]): Promise<number> {
  const { good, opened } = app.solved.value;
  const isWorksheet = of === "worksheet" || (of === "figure" && opened?.scene["figure"]?.worksheet === true);
  return isWorksheet ? await app.engine.pages(good, { worksheet: 1 }) : 1;
}

/** Saves and says so. */
export function saved(app: App, name: string, contents: Uint8Array | string, type: string): void {
  download(name, contents, type);
  app.tell(say("saved", { name }));
}

/** Does something; what the engine refuses is told. */
export async function orTell(app: App, act: () => Promise<void>): Promise<void> {
  try {
    await act();
  } catch (refused) {
    app.tell(said(refused));
  }
}
