import { zipSync } from "fflate";
import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, tick, worded } from "../../dom/worded.ts";
import { orTell } from "../../refused.ts";
import { ENDINGS } from "../output/formats.ts";
import { saved, saveOfScene, stem } from "./files.ts";
import { say } from "./words.ts";

/** The sheets of the construction in one archive, and its text. */
export function construction(app: App): HTMLElement {
  const coarse = tick(() => say("coarse"), () => name());
  const progress = element("output", { class: "quiet" });
  const count = (): number => {
    const opened = app.solved.value.opened;
    return (coarse.box.checked ? opened?.passages : opened?.steps)?.length ?? 0;
  };
  const title = (format: string): string => say("sheets", { count: count(), format: format.toUpperCase() });
  const formats = ["svg", "pdf"] as const;
  const buttons = formats.map((format) => button(() => title(format), () => void pack(format)));
  function name(): void {
    buttons.forEach((made, index) => {
      made.textContent = title(formats[index]!);
      made.disabled = count() === 0;
    });
  }
  async function pack(format: (typeof formats)[number]): Promise<void> {
    buttons.forEach((made) => (made.disabled = true));
    await orTell(app, () => sheets(app, format, coarse.box.checked, count(), (text) => (progress.textContent = text)));
    progress.textContent = "";
    name();
  }
  app.solved.on(name);
  const text = button(() => say("steps_text"), () => void saveOfScene(app, { format: "steps", of: "figure" }, "steps"));
  const tools = element("div", { class: "tools" }, ...buttons, text);
  return element("section", {}, worded(element("h3"), () => say("steps")), tools, coarse.label, progress);
}

/** Saves an archive of all sheets. */
async function sheets(app: App, format: "svg" | "pdf", coarse: boolean, count: number, tell: (text: string) => void): Promise<void> {
  const { good } = app.solved.value;
  const digits = Math.max(2, String(count).length);
  const files: Record<string, Uint8Array> = {};
  for (let number = 1; number <= count; number += 1) {
    tell(say("packing", { number, count }));
    const of = coarse ? { passage: number } : { step: number };
    files[`${stem(app)}-${String(number).padStart(digits, "0")}.${ENDINGS[format]}`] = await app.engine.file(good, { format, of });
  }
  files[`${stem(app)}-steps.txt`] = await app.engine.file(good, { format: "steps", of: "figure" });
  saved(app, `${stem(app)}-steps-${format}.zip`, zipSync(files), "application/zip");
}
