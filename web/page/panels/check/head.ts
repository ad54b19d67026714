import { element } from "../../dom/element.ts";
import { SHEETS, type Form, type FormRow } from "../../engine/types.ts";
import { measured } from "../../units.ts";
import { called, type Scale, scaleOf, type Sheet } from "../../sheets.ts";
import { type FormFile, withHead } from "./form.ts";
import { LATER } from "../parts/scene.ts";
import { say } from "./words.ts";

/** The head of the form: name, scales of the student's own sheets, what lengths are written in. */
export interface Head {
  root: HTMLElement;
  /** For a scene's form. */
  build(form: Form): void;
  show(file: FormFile): void;
}

/** The unit of a sheet's lengths: that of a quantity that is read from it. */
function unitOf(rows: FormRow[], sheet: Sheet): string {
  const length = rows.find((row) => row.unit.startsWith("mm") || row.on_paper)?.unit.split("/")[0] ?? "";
  return rows.find((row) => row.panel === sheet && row.on_paper)?.unit ?? (sheet === "scheme" ? length : "");
}

/** A symbol with a low letter, as μ_l. */
function symbol(scale: Scale): HTMLElement {
  return element("i", {}, "μ", element("sub", {}, scale.slice(-1)));
}

/** `change` is called with how the form becomes another, and with the name of the field. */
export function head(change: (how: (file: FormFile) => FormFile, field: string) => void, left: () => void): Head {
  const root = element("div", { class: "head" });
  const fields = new Map<Scale | "name", HTMLInputElement>();
  let units: HTMLInputElement[] = [];

  function scaleField(sheet: Sheet, rows: FormRow[]): HTMLElement {
    const [unit, scale] = [unitOf(rows, sheet), scaleOf(sheet)];
    const input = element("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": `${say("scales")}: ${unit}, ${called(sheet, "name")}` });
    input.oninput = () => {
      const value = measured(input.value, unit);
      const isScale = typeof value === "number" && value > 0;
      input.setAttribute("aria-invalid", String(!isScale && input.value.trim() !== ""));
      if (isScale || input.value.trim() === "") change((file) => withHead(file, scale, isScale ? value : undefined), scale);
    };
    input.onblur = left;
    fields.set(scale, input);
    const name = element("span", { title: called(sheet, "name") }, symbol(scale));
    return element("label", {}, name, input, element("small", {}, unit));
  }

  function build({ rows }: Form): void {
    fields.clear();
    const name = element("input", { type: "text", autocomplete: "name", maxlength: "200" });
    name.oninput = () => change((file) => withHead(file, "name", name.value), "name");
    name.onblur = left;
    fields.set("name", name);
    const own = [...new Set(rows.filter((row) => row.on_paper).map((row) => row.unit))].join(", ");
    units = [];
    const choice = (value: "mm" | "units", words: string, more = ""): HTMLElement => {
      const input = element("input", { type: "radio", name: "check-in", value });
      input.onchange = () => change((file) => withHead(file, "in", value === "mm" ? "mm" : undefined), "in");
      units.push(input);
      return element("label", { title: more }, input, element("span", {}, words));
    };
    root.replaceChildren(
      element("label", { class: "name" }, element("span", {}, say("name")), name),
      element("fieldset", { class: "scales" }, element("legend", {}, say("scales")), ...SHEETS.filter(({ key }) => !LATER.includes(key) || rows.some((row) => row.panel === key)).map(({ key }) => scaleField(key, rows))),
      element("fieldset", { class: "in" }, element("legend", {}, say("in")), choice("mm", say("in_mm")), choice("units", say("in_units"), own)),
    );
  }

  function show(file: FormFile): void {
    for (const [key, input] of fields) {
      const text = String(file[key] ?? "");
      const isSame = document.activeElement === input && (key === "name" ? input.value === text : measured(input.value, "") === file[key]);
      // What is no scale stays there, marked, until there is another.
      if (input.getAttribute("aria-invalid") === "true" && input.dataset["shown"] === text) continue;
      input.dataset["shown"] = text;
      if (!isSame) input.value = text;
      if (key !== "name") input.setAttribute("aria-invalid", "false");
    }
    for (const input of units) input.checked = input.value === (file.in ?? "units");
  }
  return { root, build, show };
}
