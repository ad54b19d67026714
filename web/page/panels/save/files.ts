import type { App } from "../../app.ts";
import type { FileRequest } from "../../engine/types.ts";
import { fileName, saveFile } from "../../files/save.ts";
import { orTell } from "../../refused.ts";
import { ENDINGS, type FileFormat, fileOf, PICTURES, TYPES } from "../output/formats.ts";
import { say } from "./words.ts";

/** A name for files of the present scene, without an ending. */
export function stem(app: App): string {
  return fileName(app.solved.value.opened?.title);
}

/** Saves what the engine writes of the last good scene; `part` stands in its name. */
export async function saveOfScene(app: App, request: { format: FileFormat; of: FileRequest["of"] }, part: string): Promise<void> {
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
  saveFile(name, contents, type);
  app.tell(say("saved", { name }));
}
