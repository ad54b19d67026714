/** The entry under way as a sentence with boxes: the calculator, and the whole board for who does not see. The canvas fills the same boxes. */
import { element } from "../dom/element.ts";
import { button } from "../dom/worded.ts";
import { language } from "../words.ts";
import { chipsOf, choicesOf, type Choice } from "./choices.ts";
import { isTurning } from "./entries.ts";
import type { Entry } from "./file.ts";
import type { Model } from "./model.ts";
import { lacking, slotsOf, turned, type Slot, type Takes } from "./tools.ts";
import { say } from "./words.ts";

/** Slots that are written into; the others are chosen from what there is. */
const WRITTEN: readonly Takes[] = ["formula", "formulas", "point_name", "line_name", "number_name", "names", "angle", "base"];

export interface Strip {
  root: HTMLElement;
  /** Puts the keys on what is to be filled next. */
  focus(): void;
  /** The same where that is written, and not pointed at. */
  focusWritten(): void;
}

/** Signs of a formula: those that nearly all need, and the others. */
const SIGNS = [["/", "÷"], ["^2", "²"]] as const;
const EQUATION_SIGNS = [[" = ", "="], ["\n", "↵"], ...SIGNS] as const;
const MORE_SIGNS = [["+", "+"], ["-", "−"], ["(", "("], [")", ")"]] as const;

/** What is taken away at once: a quantity with its sign of multiplication, a square, or a letter. */
const LAST_PART = /\*?[A-Za-z_]+\([^()]*\)$|\^2$|\*?\w+$|\s*.$/s;

type Box = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;
const isText = (box: Box | undefined): box is HTMLInputElement | HTMLTextAreaElement => box instanceof HTMLInputElement || box instanceof HTMLTextAreaElement;
/** Up to where a box is written: the place of the keys, or all. */
const writtenTo = (box: HTMLInputElement | HTMLTextAreaElement): number => (document.activeElement === box ? (box.selectionStart ?? box.value.length) : box.value.length);

/** `back` gives the keys back to the sheets after something was written by keys there. */
export function strip(model: Model, back: () => void): Strip {
  const form = element("form", { class: "entry-form", id: "board-entry", autocomplete: "off" });
  const chips = element("div", { class: "chips", role: "group" });
  const says = element("p", { class: "says", role: "status", tabindex: 0 });
  const draw = button(() => say("write"), () => undefined, { type: "submit", form: "board-entry", class: "main" });
  const root = element("div", { class: "strip" }, says, form, draw, chips);
  /** The boxes of the present sentence by their blanks. */
  let boxes = new Map<string, Box>();
  let shape = "";
  /** For what the chips were offered last. */
  let offered = "";
  /** The blank whose box the chips go into. */
  let chosen = "";
  /** Whether keys came from a sheet, and go back to it. */
  let fromSheet = false;

  /** The sheet that the entry is drawn on: what it says, else the one that is looked at. */
  function onOf(entry: Entry): string {
    const said = entry["on"];
    if (typeof said === "string" && said !== "") return said;
    const { value } = model.alone;
    return value !== "" && value !== "scheme" ? value : (model.known.value?.sheets.find(({ sheet }) => sheet !== "scheme")?.sheet ?? "scheme");
  }

  function fill(slot: Slot, value: string): void {
    const entry = slot.set(model.has.value, value);
    // Which sheet is meant is said as soon as something stands on it.
    const needsSheet = slotsOf(model.tool.value, entry).some(({ takes }) => takes === "sheet") && entry["on"] === undefined;
    model.fill(needsSheet ? { ...entry, on: onOf(entry) } : entry);
  }

  function boxOf(slot: Slot): Box {
    const label = say(`slot_${slot.takes}`);
    const given = { "aria-label": label, title: label, "data-blank": slot.blank };
    if (!WRITTEN.includes(slot.takes)) {
      const box = element("select", given);
      box.onchange = () => fill(slot, box.value);
      return box;
    }
    const isLong = slot.takes === "formulas";
    const box = isLong ? element("textarea", { ...given, rows: 2 }) : element("input", { ...given, type: "text", spellcheck: "false", autocapitalize: "off", inputmode: slot.takes === "angle" ? "decimal" : null });
    box.classList.add(slot.takes);
    box.oninput = () => fill(slot, box.value);
    box.onfocus = () => {
      chosen = slot.blank;
      offer();
    };
    return box;
  }

  /** Turns a vector round: a negative size runs against the direction. */
  function otherWay(): HTMLButtonElement {
    const turn = element("button", { type: "button", class: "turn", "aria-label": say("other_way"), title: say("other_way") }, "±");
    turn.onclick = () => {
      const size = slotsOf("lay_off", model.has.value).find(({ blank }) => blank === "size")!;
      const now = size.get(model.has.value).trim();
      if (now !== "") fill(size, /^-\(.*\)$/.test(now) ? now.slice(2, -1) : `-(${now})`);
    };
    return turn;
  }

  /** Turns the square by a quarter: along a link, or across it. */
  function quarter(): HTMLButtonElement {
    const turn = element("button", { type: "button", class: "turn", "data-turn": "quarter", "aria-label": say("quarter"), title: say("quarter") }, "∥⊥");
    turn.onclick = () => model.fill(turned(model.tool.value, model.has.value));
    return turn;
  }

  /** Builds the sentence anew where its boxes are others. */
  function build(): void {
    const tool = model.tool.value;
    const slots = slotsOf(tool, model.has.value);
    const next = [language.value, tool, ...slots.map(({ blank, takes }) => blank + takes)].join();
    if (next === shape) return;
    shape = next;
    chosen = "";
    const turns = tool === "lay_off" ? [otherWay()] : [];
    boxes = new Map(slots.map((slot) => [slot.blank, boxOf(slot)]));
    // The blanks of the sentence are where the boxes stand.
    const marked = Object.fromEntries(["on", "how", "reference", ...slots.map(({ blank }) => blank)].map((blank) => [blank, `\u0001${blank}\u0001`]));
    const parts = say(`form_${tool}`, marked).split("\u0001");
    form.replaceChildren(...parts.flatMap((part) => {
      const box = boxes.get(part);
      if (part === "reference" && boxes.has("base")) return [boxes.get("turned_from")!, element("span", {}, "→"), boxes.get("turned_to")!, element("span", {}, say("at_base")), boxes.get("base")!];
      return box !== undefined ? [box, ...(part === "size" ? turns : part === "how" ? [quarter()] : [])] : part.trim() === "" || part in marked ? [] : [element("span", {}, part.trim())];
    }));
    form.setAttribute("aria-label", say(`tool_${tool}`));
  }

  function show(): void {
    const known = model.known.value;
    if (known === null) return;
    build();
    const entry = model.has.value;
    const on = onOf(entry);
    for (const slot of slotsOf(model.tool.value, entry)) {
      const box = boxes.get(slot.blank);
      if (box === undefined) continue;
      const value = slot.takes === "sheet" ? on : slot.get(entry);
      if (box instanceof HTMLSelectElement) {
        const choices = choicesOf(slot.takes, known, on);
        const all: Choice[] = slot.takes === "sheet" || slot.takes === "how" || slot.takes === "sense" ? choices : [["", "…"], ...choices];
        // A value that the canvas has found may be none of those that are offered.
        if (value !== "" && !all.some(([name]) => name === value)) all.push([value, value]);
        const key = JSON.stringify(all);
        if (box.dataset["choices"] !== key) box.replaceChildren(...all.map(([name, shown]) => element("option", { value: name }, shown)));
        box.dataset["choices"] = key;
      }
      // A sense is that of a link's rate.
      if (slot.takes === "sense") box.hidden = !isTurning(entry["compute"], known);
      // What is written stays as it is written, if it says the same.
      const isSame = slot.get(slot.set(entry, box.value)) === value;
      if (!isSame && document.activeElement !== box) box.value = value;
      if (box.value !== value && box instanceof HTMLSelectElement) box.value = value;
      box.classList.toggle("lacking", model.wantsSense.value ? slot.takes === "sense" : lacking(model.tool.value, entry)?.blank === slot.blank);
    }
    // On a narrow screen the sentence is one line, of which what comes next is seen.
    if (form.scrollWidth > form.clientWidth) {
      const next = form.querySelector<HTMLElement>(".lacking");
      if (next !== null && !form.contains(document.activeElement)) form.scrollTo({ left: next.offsetLeft - form.offsetLeft - 60 });
    }
    offer();
  }

  /** Names and numbers to choose from, for the box that is written in, or that comes next. */
  function offer(): void {
    const known = model.known.value;
    if (known === null) return;
    if (model.between.value.length > 0) {
      chips.setAttribute("aria-label", say(model.between.value[0]!.direction === null ? "slot_point" : "slot_direction"));
      return chips.replaceChildren(...model.between.value.map((snap) => {
        const take = (): void => void model.inTurn(async () => {
          await model.take(snap);
          if (fromSheet) back();
          fromSheet = false;
        });
        if (snap.direction !== null) return pressed(element("button", { type: "button", "data-name": snap.words }, snap.words), take);
        const label = known.things.find(({ kind, name }) => kind === "point" && name === snap.words)?.label ?? "";
        return pressed(chipOf(snap.words, label, ""), take);
      }));
    }
    const entry = model.has.value;
    const slots = slotsOf(model.tool.value, entry);
    const next = lacking(model.tool.value, entry);
    const last = slots.find(({ blank }) => blank === chosen);
    // What is written in; what comes next, if that is written; else a formula goes on.
    const isIn = last !== undefined && document.activeElement === boxes.get(chosen);
    const slot = model.wantsSense.value ? slots.find(({ takes }) => takes === "sense") : isIn ? last : next !== undefined && WRITTEN.includes(next.takes) ? next : last?.takes === "formula" ? last : undefined;
    const all = slot === undefined ? [] : chipsOf(slot.takes, known, entry, onOf(entry));
    if (slot === undefined) return chips.replaceChildren();
    chips.setAttribute("aria-label", say(`slot_${slot.takes}`));
    // What is offered anew is seen from its beginning: the signs after a number, the names of another box.
    const offers = `${model.tool.value} ${slot.blank} ${slot.get(entry)}`;
    if (offers !== offered) chips.scrollTo({ left: 0 });
    offered = offers;
    const numbers = all.map(({ name, label, value }) => pressed(chipOf(name, label, value), (isFinger) => void pick(slot, name, isFinger)));
    // A formula is written by presses alone, too.
    const isFormula = (slot.takes === "formula" || slot.takes === "formulas") && slot.get(entry) !== "";
    const sign = ([written, shown]: readonly [string, string]): HTMLButtonElement => pressed(element("button", { type: "button", class: "sign", "data-sign": written }, shown), (isFinger) => put(slot, written, isFinger));
    const takesBack = pressed(element("button", { type: "button", class: "sign", "data-sign": "back", "aria-label": say("sign_back"), title: say("sign_back") }, "⌫"), (isFinger) => put(slot, "", isFinger));
    const signs = slot.takes === "formulas" ? EQUATION_SIGNS : SIGNS;
    chips.replaceChildren(...(isFormula ? [...signs.map(sign), ...numbers, ...MORE_SIGNS.map(sign), takesBack] : numbers));
  }

  /** `label` is the engine's HTML. */
  function chipOf(name: string, label: string, value: string): HTMLButtonElement {
    const chip = element("button", { type: "button", "data-name": name });
    const shown = element("i");
    shown.innerHTML = label;
    chip.append(shown, ...(value === "" ? [] : [element("small", {}, value)]));
    return chip;
  }

  /** A button of the chips: what is written in keeps the keys. */
  function pressed(chip: HTMLButtonElement, act: (isFinger: boolean) => void): HTMLButtonElement {
    chip.onpointerdown = (event) => event.preventDefault();
    chip.onclick = (event) => chip.isConnected && act(event.pointerType === "touch");
    return chip;
  }

  /** Puts a part of a formula where it is written on, and goes on there by keys; a finger needs none. Nothing takes the last part away. */
  function put(slot: Slot, part: string, isFinger: boolean): void {
    const box = boxes.get(slot.blank);
    if (!isText(box)) return;
    const at = writtenTo(box);
    const head = part === "" ? box.value.slice(0, at).replace(LAST_PART, "") : box.value.slice(0, at) + part;
    const whole = head + box.value.slice(at);
    chosen = slot.blank;
    box.value = whole;
    fill(slot, whole);
    if (isFinger) return;
    box.focus();
    box.setSelectionRange(head.length, head.length);
  }

  async function pick(slot: Slot, name: string, isFinger: boolean): Promise<void> {
    const box = boxes.get(slot.blank);
    chosen = slot.blank;
    if (slot.takes === "formula" || slot.takes === "formulas" || slot.takes === "names") {
      const before = isText(box) ? box.value.slice(0, writtenTo(box)) : "";
      const joint = slot.takes === "names" ? ", " : "*";
      // Two quantities one after the other are multiplied.
      const link = before !== "" && !/[-+*/^(=,\s]$/.test(before) ? joint : "";
      return put(slot, link + name, isFinger);
    }
    fill(slot, name);
    if (box !== undefined) box.value = name;
    // With its name an entry of the canvas is whole.
    if (lacking(model.tool.value, model.has.value) === undefined && (slot.takes === "point_name" || slot.takes === "sense")) await write();
  }

  async function write(): Promise<void> {
    await model.inTurn(async () => {
      const next = lacking(model.tool.value, model.has.value);
      // What is pointed at is pointed at on the sheets.
      if (fromSheet && next !== undefined && !WRITTEN.includes(next.takes)) return back();
      const isWritten = await model.write();
      if (!isWritten) return own.focus();
      if (fromSheet) back();
      fromSheet = false;
    });
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    void write();
  });
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    fromSheet = false;
    back();
  });
  chips.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by === undefined) return;
    const all = [...chips.querySelectorAll<HTMLButtonElement>("button")];
    all[(all.indexOf(document.activeElement as HTMLButtonElement) + by + all.length) % all.length]?.focus();
    event.preventDefault();
  });

  const own: Strip = {
    root,
    focusWritten() {
      const next = lacking(model.tool.value, model.has.value);
      if (model.between.value.length > 0 || (next !== undefined && WRITTEN.includes(next.takes))) own.focus();
    },
    focus() {
      fromSheet = root.parentElement?.querySelector(".over:focus") !== null;
      const next = lacking(model.tool.value, model.has.value);
      const box = next === undefined ? draw : boxes.get(next.blank);
      offer();
      // A name, a sense or one of several things is chosen from what is offered.
      const isChosen = next?.takes === "point_name" || model.wantsSense.value || model.between.value.length > 0;
      const chip = isChosen ? chips.querySelector("button") : null;
      (chip ?? box)?.focus();
    },
  };
  model.says.on(({ text, isBad }) => {
    says.textContent = text;
    says.classList.toggle("bad", isBad);
  });
  model.wantsSense.on(show);
  model.between.on(show);
  model.has.on(show);
  model.tool.on(show);
  model.known.on(show);
  model.alone.on(show);
  language.on(show);
  return own;
}
