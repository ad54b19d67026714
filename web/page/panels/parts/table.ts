import { element, svgElement } from "../../dom/element.ts";
import { askedFor, textOf } from "../../files/open.ts";
import { shownNumber } from "../../number.ts";
import { said } from "../../refused.ts";
import { edit } from "./edits.ts";
import { labelled, newId, typing, type Desk, type Live } from "./fields.ts";
import type { TableField } from "./form.ts";
import { at, type Draft } from "./scene.ts";
import { say } from "./words.ts";

/** Files that hold tables. */
const TABLES = ".csv,.tsv,.txt,text/csv,text/plain";

/** A table of two columns: its lines typed, pasted or taken from a file, and the curve that they are. */
export function tableOf({ app }: Desk, field: TableField): Live {
  const input = element("textarea", { rows: 6, spellcheck: "false", autocomplete: "off" });
  const curve = svgElement("svg", { viewBox: "0 0 100 40", preserveAspectRatio: "none", "aria-hidden": "true" });
  const why = element("p", { class: "why", role: "alert", hidden: true });
  let gesture = newId();
  const refuse = (message: string | null): void => {
    why.textContent = message ?? "";
    why.hidden = message === null;
  };
  const take = async (text: string): Promise<void> => {
    try {
      const lines = await app.engine.load_table(text, field.load);
      refuse(null);
      if (lines.length > 0) await edit(app, [{ set: field.path, value: lines }], gesture);
    } catch (refused) {
      refuse(said(refused));
    }
  };
  const typist = typing(app, (isPaused) => void (isPaused && take(input.value)));
  input.addEventListener("focus", () => (gesture = newId()));
  input.addEventListener("input", typist.typed);
  input.addEventListener("blur", typist.paused);
  const file = element("button", { type: "button", class: "small" }, say("table_file"));
  file.addEventListener("click", async () => {
    const chosen = await askedFor(TABLES);
    const text = chosen === null ? null : await textOf(chosen);
    gesture = newId();
    if (text !== null) await take(text);
  });
  const root = labelled(field, input, element("div", { class: "beside" }, curve, file));
  root.classList.add("table");
  root.append(why);
  return {
    root,
    show(scene) {
      const lines = linesOf(scene, field);
      curve.replaceChildren(...curveOf(lines));
      if (document.activeElement === input) return;
      const isComma = at(scene, ["figure", "decimal"]) === "comma";
      const text = lines.map((line) => line.map((value) => shownNumber(value, isComma).replace("−", "-")).join(isComma ? "; " : ", ")).join("\n");
      if (input.value !== text) input.value = text;
    },
  };
}

function linesOf(scene: Draft, { path }: TableField): [number, number][] {
  const lines = at(scene, path);
  const isLine = (line: unknown): line is [number, number] => Array.isArray(line) && line.length === 2 && line.every((value) => typeof value === "number");
  return Array.isArray(lines) ? lines.filter(isLine) : [];
}

/** The curve of the lines, and the line of zero. */
function curveOf(lines: [number, number][]): SVGElement[] {
  if (lines.length < 2) return [];
  const [across, up] = [lines.map(([x]) => x), [0, ...lines.map(([, y]) => y)]];
  const [left, right, low, high] = [Math.min(...across), Math.max(...across), Math.min(...up), Math.max(...up)];
  const place = ([x, y]: [number, number]): string => `${((100 * (x - left)) / (right - left || 1)).toFixed(2)} ${(38 - (36 * (y - low)) / (high - low || 1)).toFixed(2)}`;
  const zero = `M${place([left, 0])}L${place([right, 0])}`;
  return [svgElement("path", { class: "zero", d: zero }), svgElement("path", { d: `M${lines.map(place).join("L")}` })];
}
