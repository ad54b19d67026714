import type { App } from "../../app.ts";
import { drawingOf, drawingText } from "../../board/file.ts";
import { goodText } from "../../state/solving.ts";
import { formFile, formText, MOST_HINTS, withHints } from "./form.ts";

/** Notes that the answers were shown, as all hints of every box: in the drawing, and in the form where it was the form that showed them. */
export async function noteAnswers(app: App, of: "form" | "drawing"): Promise<void> {
  const { rows } = await app.engine.form(await goodText(app), "");
  const hints = MOST_HINTS * rows.filter((row) => row.is_asked).length;
  const { form, drawing } = app.history.now.value;
  const file = of === "form" ? formFile(form) : null;
  if (file !== null) app.history.change({ form: formText(withHints(file, hints)) });
  const drawn = drawingOf(drawing ?? "");
  if (drawn !== null && hints > (drawn.hints ?? 0)) app.history.draw(drawingText({ ...drawn, hints }));
}
