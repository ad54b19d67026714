import type { App } from "../../app.ts";
import type { Picture } from "../../engine/types.ts";
import { boxAround, type Box } from "./sheet.ts";

/** A scene's mechanism alone, to be seen small, and the box around it. */
export async function alone(app: App, text: string): Promise<{ picture: Picture; box: Box | undefined }> {
  const figure = { panels: ["scheme"], focus: "scheme", page: "16x9", style: "lecture", values: false, special_points: false, construction: false };
  const small = await app.engine.edit(text, [{ set: ["figure"], value: figure }]);
  const picture = await app.engine.picture(small, { step: null, coarse: false, modes: false });
  return { picture, box: boxAround(picture.handles.map(({ at }) => at)) ?? picture.panels.find(({ key }) => key === "scheme")?.box };
}
