import type { App } from "../../app.ts";
import type { Exercise } from "../../engine/types.ts";
import { begun, formText } from "../check/form.ts";

/** The address that a student gets: the exercise's scene and its empty form, without the key; the plans are not shown. */
export function studentLink(app: App, { text, form }: Exercise): Promise<string> {
  return app.link({ text, form: formText(begun(form, true)), panel: "check", student: true });
}
