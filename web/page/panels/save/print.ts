import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, worded } from "../../dom/worded.ts";
import type { FileRequest, SheetPicture } from "../../engine/types.ts";
import { said } from "../../refused.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { language } from "../../words.ts";
import { keepCurrent } from "../output/current.ts";
import { oneOf } from "../output/one_of.ts";
import { sheet, sizeOf } from "../output/sheet.ts";
import { pagesOf } from "./files.ts";
import { say } from "./words.ts";

const WHAT = ["figure", "worksheet", "step"] as const;
type What = (typeof WHAT)[number];

/** Papers by their sides in mm, the shorter one first. */
const PAPERS: Record<string, string> = { "210 297": "A4", "297 420": "A3", "215.9 279.4": "Letter" };

/** The exact sheets, with their size, and a button that prints them. */
export function print(app: App): HTMLElement {
  const what = signal<What>("figure");
  const message = element("p", { role: "alert", class: "bad" });
  const preview = worded(element("div", { class: "preview", role: "group" }), () => say("preview"), "aria-label");
  const ruler = worded(element("p", { class: "quiet" }), () => say("ruler"));
  let sheets: string[] = [];
  const sized = (svg: string): SheetPicture => {
    const [width, height] = sizeOf(svg);
    return { svg, width, height };
  };
  const press = button(() => say("print_now"), () => app.print(sheets.map(sized)), { class: "main" });
  keepCurrent(app, "save", [app.solved, app.view, what, language], async () => {
    const { good, opened } = app.solved.value;
    if (opened === null) return;
    ruler.hidden = what.value !== "worksheet";
    try {
      sheets = await drawn(app, good, requested(what.value, app));
      message.textContent = "";
      preview.replaceChildren(...sheets.map((svg, index) => shown(svg, index, sheets.length)));
    } catch (refused) {
      message.textContent = said(refused);
    }
    press.disabled = sheets.length === 0;
  });
  return element(
    "section",
    { class: "print" },
    worded(element("h3"), () => say("print")),
    choice(app, what),
    message,
    preview,
    worded(element("p", { class: "quiet" }), () => say("to_scale")),
    ruler,
    press,
  );
}

/** What is to be printed. */
function choice(app: App, what: Signal<What>): HTMLElement {
  const step = (): string | null => (app.view.value.step === null ? null : say("this_step", { number: app.view.value.step }));
  const options = oneOf(what, WHAT, () => say("print"), (value) => (value === "step" ? step() : say(value)));
  app.view.on((view) => {
    options.rename();
    if (view.step === null && what.value === "step") what.set("figure");
  });
  return options.root;
}

function requested(what: What, app: App): FileRequest["of"] {
  return what === "step" ? { step: app.view.value.step ?? 1 } : what;
}

/** The sheets of a drawing as SVG. */
async function drawn(app: App, text: string, of: FileRequest["of"]): Promise<string[]> {
  const sheets: string[] = [];
  const count = await pagesOf(app, of);
  for (let number = 1; number <= count; number += 1) {
    const bytes = await app.engine.file(text, { format: "svg", of: number === 1 ? of : { worksheet: number } });
    sheets.push(new TextDecoder().decode(bytes));
  }
  return sheets;
}

/** A sheet with its size below. */
function shown(svg: string, index: number, count: number): HTMLElement {
  const picture = sheet(true);
  picture.show(svg);
  const [width, height] = sizeOf(svg);
  const name = PAPERS[[width, height].sort((a, b) => a - b).join(" ")] ?? "";
  const number = count > 1 ? `${say("on", { number: index + 1, count })}: ` : "";
  const size = say("size", { name, width, height }).trim();
  return element("figure", {}, picture.root, element("figcaption", { class: "quiet" }, number + size));
}
