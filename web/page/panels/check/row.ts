import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import type { FormRow } from "../../engine/types.ts";
import { type FormFile, type Value, valueOf } from "./form.ts";
import { afterTyping, type Chosen, isZero, sensed, signed } from "./sense.ts";
import { senseButtons } from "./sense_buttons.ts";
import { isFormula, taken, unitsBeside, withTyped } from "./units.ts";
import { showVerdict, type Verdict } from "./verdict.ts";
import { say } from "./words.ts";

/** What a row tells the panel. */
export interface RowEvents {
  /** The value is another; `isTyping` while the field has not been left. */
  changed(name: string, value: Value, isTyping: boolean): void;
  /** The field has been left. */
  left(name: string): void;
}

export interface Row {
  root: HTMLElement;
  input: HTMLInputElement;
  /** Shows the value that the form has; `fromPoints` is what the marked points give where nothing is written, `is` what a value with a unit comes to. */
  show(file: FormFile, fromPoints: string | null, is: string | null): void;
  judge(verdict: Verdict | null): void;
}

let last = 0;

/** A box of the form: label, number, unit, sense, verdict. */
export function row(of: FormRow, events: RowEvents): Row {
  const id = `check-${(last += 1)}`;
  const label = element("label", { for: id, title: of.caption === "" ? "" : `${say("step", { step: of.step })}: ${of.caption}` });
  label.innerHTML = of.label;
  if (of.vector !== "") {
    const vector = element("small");
    vector.innerHTML = of.vector;
    label.append(element("span", { class: "unseen" }, " – "), vector);
  }
  const name = label.textContent ?? of.name;
  const input = element("input", {
    id,
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    spellcheck: "false",
    enterkeyhint: "next",
    "aria-describedby": `${id}-echo ${id}-verdict`,
  });
  const unit = element("select", { "aria-label": say("unit_of", { name }) });
  const paper = element("span", { class: "paper" }, say("mm"));
  const verdict = element("span", { class: "verdict", id: `${id}-verdict` });
  const note = element("span", { class: "note" });
  const echo = element("span", { class: "echo", id: `${id}-echo` });
  let file: FormFile = { kinegon_measured: 1 };
  let chosen: Chosen = { sense: "", isTyped: false, hasSign: false };
  /** Whether only a part of what stands in the box is being replaced. */
  let isEdited = false;
  const senses = of.has_sense ? senseButtons(name, of.turns, (sense) => ((chosen = { sense, isTyped: false, hasSign: false }), put(false))) : null;

  /** What the fields say, as the form has it. */
  function value(): Value {
    const typed = taken(input.value);
    const { size } = sensed(typed.digits, of.turns, undefined);
    const digits = of.has_sense ? signed(size, chosen.sense, of.turns, file.positive) : typed.digits;
    // A typed unit belongs to what was typed; one that is chosen stays for what is typed next.
    if (typed.unit !== null) return { digits: withTyped(digits, typed.unit), unit: null, onPaper: false };
    if (unit.hidden || unit.value === "/mu") return { digits, unit: null, onPaper: !unit.hidden };
    // Without a unit a segment is in mm of paper, where the form says so.
    const isOwn = unit.value === "" && !(file.in === "mm" && of.is_segment);
    return { digits, unit: isOwn ? null : unit.value || of.unit, onPaper: false };
  }

  /** What the value comes to, where it is not what stands there. */
  function showEcho(is: string | null): void {
    const { digits, unit: typed } = taken(input.value);
    const isPaper = !paper.hidden && typed === null;
    const ofFormula = isFormula(input.value) && typed === null ? (isPaper ? say("is_on_paper", { value: digits }) : `= ${digits}`) : null;
    echo.textContent = ofFormula ?? is ?? "";
  }

  function put(isTyping: boolean): void {
    events.changed(of.name, value(), isTyping);
  }

  function showUnits(own: Value): void {
    const all = unitsBeside(of.unit);
    if (own.unit !== null && !all.includes(own.unit)) all.push(own.unit);
    const options = all.map((name, index) => new Option(name, index === 0 ? "" : name));
    if (of.on_paper) options.push(new Option(say("on_paper"), "/mu"));
    unit.replaceChildren(...options);
    unit.value = own.onPaper ? "/mu" : own.unit === null || own.unit === of.unit ? "" : own.unit;
  }

  input.onbeforeinput = () => void (isEdited = input.selectionStart !== 0 || input.selectionEnd !== input.value.length);
  input.oninput = () => {
    chosen = afterTyping(chosen, taken(input.value).digits, !isEdited, of.turns, file.positive);
    isEdited = false;
    put(true);
    showEcho(null);
  };
  input.onblur = () => {
    // A sign without a number is none; that of a number is on the buttons now.
    const isEmpty = sensed(taken(input.value).digits, of.turns, undefined).size.trim() === "";
    chosen = { ...chosen, hasSign: false, ...(isEmpty && chosen.isTyped ? { sense: "" } : {}) };
    events.left(of.name);
    show(file, note.textContent === "" ? null : input.placeholder, null);
  };
  unit.onchange = () => put(false);

  function show(now: FormFile, fromPoints: string | null, is: string | null): void {
    file = now;
    const own = valueOf(now, of.name);
    const { size, sense } = of.has_sense ? sensed(own.digits, of.turns, now.positive) : { size: own.digits, sense: "" as const };
    // What comes from elsewhere is as if it were typed.
    const isNone = own.digits === "" || (isZero(own.digits) && sense === "");
    if (!isNone && sense !== chosen.sense) chosen = { sense, isTyped: true, hasSign: chosen.hasSign };
    const isSame = document.activeElement === input && value().digits === own.digits;
    if (!isSame) input.value = size;
    if (!isSame || document.activeElement !== input) showUnits(own);
    // What points give is in the value's own unit.
    const isFromPoints = own.digits === "" && fromPoints !== null;
    const hasTyped = taken(own.digits).unit !== null;
    const isPaper = file.in === "mm" && of.is_segment && !own.onPaper && own.unit === null && !isFromPoints && !hasTyped;
    input.classList.toggle("with-unit", hasTyped);
    unit.hidden = isPaper || hasTyped;
    paper.hidden = !isPaper;
    showEcho(is);
    senses?.show(isNone ? chosen.sense : sense);
    input.placeholder = fromPoints ?? "";
    note.title = isFromPoints ? say("from_points") : "";
    note.replaceChildren(...(isFromPoints ? [icon("pin"), element("span", { class: "unseen" }, say("from_points"))] : []));
  }

  return {
    root: element("div", { class: "row" }, label, input, element("span", { class: "unit" }, unit, paper), ...(senses ? [senses.root] : []), note, echo, verdict),
    input,
    show,
    judge(found) {
      showVerdict(verdict, found);
      const isWrong = found?.kind === "off" || found?.kind === "fault";
      input.setAttribute("aria-invalid", String(isWrong));
      senses?.root.classList.toggle("missing", found?.kind === "sense-missing");
    },
  };
}
