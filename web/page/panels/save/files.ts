import type { App } from "../../app.ts";
import type { FileRequest } from "../../engine/types.ts";
import { said } from "../output/current.ts";
import { download, ENDINGS, fileName, TYPES } from "../output/download.ts";
import { say } from "./words.ts";

/** Forms of a picture, with their names for people. */
export const PICTURES = [["svg", "SVG"], ["pdf", "PDF"], ["png", "PNG"], ["tikz", "TikZ"]] as const;

/** A name for files of the present scene, without an ending. */
export function stem(app: App): string {
  return fileName(app.solved.value.opened?.title ?? "");
}

/** Saves a file of the last good scene; `part` stands in its name. */
export async function saveFile(app: App, request: FileRequest, part: string): Promise<void> {
  const { good } = app.solved.value;
  const name = [stem(app), part].filter(Boolean).join("-");
  await orTell(app, async () => {
    const count = await pagesOf(app, request.of);
    for (let number = 1; number <= count; number += 1) {
      const of = number === 1 ? request.of : { worksheet: number };
      const bytes = await app.engine.file(good, { ...request, of });
      saved(app, `${name}${number === 1 ? "" : `-${number}`}.${ENDINGS[request.format]}`, bytes, TYPES[request.format]);
    }
  });
}

/** How many sheets of paper a drawing takes. */
export async function pagesOf(app: App, of: FileRequest["of"]): Promise<number> {
  return of === "worksheet" ? await app.engine.pages(app.solved.value.good, of) : 1;
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
