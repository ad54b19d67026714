import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import { calmed } from "../../dom/piles.ts";
import type { Edit } from "../../engine/types.ts";
import { shownNumber, stepped } from "../../number.ts";
import { measured } from "../../units.ts";
import { edit } from "./edits.ts";
import type { Adder, Ask, ChecksField, ChoiceField, Field, NameField, Names, NumberField, Option, PointsField, SwitchField, TextField } from "./form.ts";
import { pinButton } from "./pin.ts";
import { at, dotted, type Draft, type Path } from "./scene.ts";
import { tableOf } from "./table.ts";
import { say } from "./words.ts";

/** A part of the form that shows a value of the scene. */
export interface Live {
  root: HTMLElement;
  /** Shows what the scene gives. */
  show(scene: Draft): void;
}

let count = 0;

/** An id that no other element has. */
export function newId(): string {
  count += 1;
  return `field-${count}`;
}

/** The change that puts a value at a path, or removes it. */
function put(path: Path, value: unknown): Edit {
  return value === undefined ? { remove: path } : { set: path, value };
}

/** The page, and who does what a field asks for. */
export interface Desk {
  app: App;
  owner: { asked?(ask: Ask): void };
}

/** The element of a field. */
export function fieldOf(desk: Desk, field: Field): Live {
  const { app } = desk;
  switch (field.kind) {
    case "number":
      return numberInput(app, field);
    case "text":
      return textInput(app, field);
    case "choice":
      return field.open === true && Array.isArray(field.options) ? openChoice(desk, field, field.options) : select(desk, field);
    case "checks":
      return checks(app, field);
    case "switch":
      return onOff(app, field);
    case "points":
      return pointNames(desk, field);
    case "adder":
      return adder(desk, field);
    case "table":
      return tableOf(desk, field);
  }
}

/** A label with its input. */
export function labelled(field: { path: Path; label: string; symbol?: string; quiet?: boolean }, input: HTMLElement, ...more: HTMLElement[]): HTMLElement {
  input.id = newId();
  const { symbol } = field;
  const words = symbol === undefined ? [field.label] : [element("span", { "aria-hidden": "true", title: field.label }, symbol), element("span", { class: "unseen" }, field.label)];
  const label = element("label", { for: input.id, class: field.quiet === true ? "unseen" : null }, ...words);
  return element("div", { class: "field", "data-path": dotted(field.path) }, label, element("div", { class: "value" }, input, ...more));
}

function textInput(app: App, field: TextField): Live {
  const input = element("input", { type: "text", autocomplete: "off", placeholder: field.usual });
  let gesture = newId();
  input.addEventListener("focus", () => (gesture = newId()));
  input.addEventListener("input", () => {
    void edit(app, [put(field.path, input.value === "" && field.keepsEmpty !== true ? undefined : input.value)], gesture);
  });
  const root = labelled(field, input);
  root.classList.add("wide");
  return {
    root,
    show(scene) {
      const value = at(scene, field.path);
      const text = calmed(typeof value === "string" ? value : "");
      if (input.value !== text) input.value = text;
    },
  };
}

/** Which option the scene gives. */
function chosen(options: Option[], value: unknown): number {
  const exactly = options.findIndex((option) => option.any === undefined && JSON.stringify(option.value) === JSON.stringify(value));
  if (exactly >= 0) return exactly;
  const form = Array.isArray(value) ? "list" : typeof value;
  return options.findIndex((option) => option.any === form);
}

function choose({ app, owner }: Desk, field: ChoiceField, option: Option | undefined): void {
  if (option === undefined) return;
  if (option.ask !== undefined) owner.asked?.(option.ask);
  else void edit(app, option.edits ?? [put(field.path, option.value)]);
}

function select(desk: Desk, field: ChoiceField): Live {
  if (typeof field.options === "function") return selectName(desk, field, field.options);
  const { options } = field;
  const input = element("select", {}, ...options.map(({ text }, index) => element("option", { value: index }, text)));
  input.addEventListener("change", () => choose(desk, field, options[Number(input.value)]));
  return { root: labelled(field, input), show: (scene) => (input.value = String(field.now ?? chosen(options, at(scene, field.path)))) };
}

/** One of the scene's names. */
function selectName(desk: Desk, field: ChoiceField, options: Names): Live {
  const input = element("select", {});
  const names = namesIn(input, options);
  input.addEventListener("change", () => choose(desk, field, { value: input.value, text: input.value }));
  return { root: labelled(field, input), show: (scene) => names.show(scene, String(at(scene, field.path) ?? "")) };
}

/** Most names that a list has before somebody comes to it. */
const AT_HAND = 60;

/**
 * Keeps the names of a list those of the scene: all of them, or, where they are many, the one that is chosen, until somebody comes to
 * the list. Without `chosen` a list whose names have changed begins anew with its first.
 */
function namesIn(input: HTMLSelectElement, options: Names): { show(scene: Draft, chosen?: string): void } {
  let now: Draft = {};
  let basis = "";
  const put = (wanted: { value: string; text: string }[], value: string | undefined): void => {
    input.replaceChildren(...wanted.map((option) => element("option", { value: option.value }, option.text)));
    if (value !== undefined) input.value = value;
  };
  const isAll = (): boolean => input.options.length > 1;
  const all = (): void => {
    if (!isAll()) put([...options(now)], input.value);
  };
  for (const coming of ["focus", "pointerdown", "pointerenter"]) input.addEventListener(coming, all);
  return {
    show(scene, chosen) {
      now = scene;
      const first: { value: string; text: string }[] = [];
      for (const option of options(scene)) if (first.push(option) > AT_HAND) break;
      const isLong = first.length > AT_HAND;
      const next = JSON.stringify(first);
      if (next !== basis || (isLong && isAll() && document.activeElement !== input)) {
        const alone = chosen === undefined ? first.slice(0, 1) : [{ value: chosen, text: chosen }];
        put(isLong ? alone : first, chosen);
        if (isLong && document.activeElement === input) put([...options(scene)], chosen);
      }
      basis = next;
      if (chosen === undefined || input.value === chosen) return;
      if (isLong) put([{ value: chosen, text: chosen }], chosen);
      else input.value = chosen;
    },
  };
}

/** All options side by side. */
function openChoice(desk: Desk, field: ChoiceField, all: Option[]): Live {
  const name = newId();
  const inputs = all.map((option, index) => element("input", { type: "radio", name, value: index, onchange: () => choose(desk, field, option) }));
  const options = all.map(({ text }, index) => element("label", { class: "option" }, inputs[index], element("span", {}, text)));
  const legend = element("legend", { class: field.quiet === true ? "unseen" : null }, field.label);
  const root = element("fieldset", { class: "field open", "data-path": dotted(field.path) }, legend, element("div", { class: "options" }, ...options));
  return {
    root,
    show(scene) {
      const index = chosen(all, at(scene, field.path));
      inputs.forEach((input, other) => (input.checked = other === index));
    },
  };
}

function checks(app: App, field: ChecksField): Live {
  let given: string[] = [];
  const mark = (): void => field.options.forEach(({ value }, index) => (inputs[index]!.checked = given.includes(value)));
  const toggled = (name: string, on: boolean): void => {
    const next = field.options.map(({ value }) => value).filter((value) => (value === name ? on : given.includes(value)));
    if (next.length === 0 && field.needed === true) return mark();
    const isUsual = JSON.stringify(next) === JSON.stringify(field.usual ?? []);
    void edit(app, [put(field.path, isUsual ? undefined : next)]);
  };
  const inputs = field.options.map(({ value }) => {
    const input = element("input", { type: "checkbox" });
    input.addEventListener("change", () => toggled(value, input.checked));
    return input;
  });
  const options = field.options.map(({ text }, index) => element("label", { class: "tick" }, inputs[index], element("span", {}, text)));
  const legend = element("legend", { class: field.quiet === true ? "unseen" : null }, field.label);
  const root = element("fieldset", { class: "field open", "data-path": dotted(field.path) }, legend, element("div", { class: "checks" }, ...options));
  return {
    root,
    show(scene) {
      const value = at(scene, field.path);
      given = Array.isArray(value) ? (value as string[]) : (field.usual ?? []);
      mark();
    },
  };
}

function onOff(app: App, field: SwitchField): Live {
  const input = element("input", { type: "checkbox" });
  input.addEventListener("change", () => void edit(app, [put(field.path, input.checked === field.usual ? undefined : input.checked)]));
  const label = element("label", { class: "tick" }, input, element("span", {}, field.label));
  return {
    root: element("div", { class: "field", "data-path": dotted(field.path) }, label),
    show: (scene) => (input.checked = (at(scene, field.path) ?? field.usual) === true),
  };
}

/** Names of a link's points, each with its pin. */
function pointNames({ app, owner }: Desk, field: PointsField): Live {
  const chips = field.points.map(({ name, label, remove, ask }) => {
    const button = element("button", { type: "button", class: "bare", "aria-label": remove, title: remove }, icon("remove"));
    button.addEventListener("click", () => owner.asked?.(ask));
    return element("div", { class: "chip" }, nameInput(app, { of: "point", name, label }), pinButton(app, { point: name }), button);
  });
  const legend = element("legend", { class: field.quiet === true ? "unseen" : null }, field.label);
  const root = element("fieldset", { class: "field open", "data-path": dotted(field.path) }, legend, element("div", { class: "chips" }, ...chips));
  return { root, show: () => undefined };
}

/** Lists and a button that adds what is chosen in them. */
function adder({ owner }: Desk, field: Adder): Live {
  const lists = field.lists.map(({ label }) => element("select", { "aria-label": label, title: label }));
  const names = field.lists.map(({ options }, index) => namesIn(lists[index]!, options));
  const button = element("button", { type: "button", class: "small", "aria-label": `+ ${field.text}` }, icon("plus"), field.text);
  button.addEventListener("click", () => owner.asked?.({ do: field.ask.do, with: [...field.ask.with, ...lists.map(({ value }) => value)] }));
  const root = element("div", { class: "field adder", role: "group", "aria-label": field.label, "data-path": dotted(field.path) }, ...lists, button);
  return { root, show: (scene) => names.forEach((each) => each.show(scene)) };
}

/** The name of a point or link; a change of it is made everywhere when the field is left. */
export function nameInput(app: App, { of, name, label }: NameField): HTMLElement {
  const input = element("input", { type: "text", class: "name", value: name, "aria-label": label, autocomplete: "off", spellcheck: "false", autocapitalize: "off" });
  input.size = Math.max(2, name.length);
  const why = element("p", { class: "why", role: "alert", hidden: true });
  const refuse = (message: string | null): void => {
    input.setAttribute("aria-invalid", String(message !== null));
    why.textContent = message ?? "";
    why.hidden = message === null;
  };
  const renamed = async (): Promise<void> => {
    const to = input.value.trim();
    if (to === name) return refuse(null);
    if (to === "") return refuse(say("nameless"));
    refuse((await edit(app, [{ rename: of, from: name, to }]))?.message ?? null);
  };
  input.addEventListener("change", () => void renamed());
  input.addEventListener("input", () => (input.size = Math.max(2, input.value.length)));
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || (input.value === name && why.hidden)) return;
    event.preventDefault();
    input.value = name;
    refuse(null);
  });
  return element("div", { class: "naming" }, input, why);
}

/** After how long without a letter a number counts as typed, in ms. */
const PAUSE = 900;

/** Who types on pauses for less, in ms: what stands there before is not taken for a number, for a unit may follow. */
const BETWEEN_LETTERS = 250;

/** Hears of the letters, as soon as they come no faster, and of the pause after the last. */
export function typing(app: App, read: (isPaused: boolean) => void): { typed(): void; paused(): void } {
  let [clock, letters] = [0, 0];
  const paused = (): void => {
    if (clock === 0) return;
    clearTimeout(clock);
    clearTimeout(letters);
    clock = 0;
    read(true);
    app.typing.set(false);
  };
  return {
    typed() {
      clearTimeout(clock);
      clearTimeout(letters);
      clock = window.setTimeout(paused, PAUSE);
      letters = window.setTimeout(() => read(false), BETWEEN_LETTERS);
      app.typing.set(true);
    },
    paused,
  };
}

/** How many steps a key goes. */
const KEYS: Record<string, number> = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/**
 * A field for a number. Typing changes the scene as soon as a number stands there, in whatever unit; arrow keys and the wheel go by steps. What
 * is typed while it has the focus is one entry of undo. What cannot be read stays there, with why, and the scene is as it was before.
 */
function numberInput(app: App, field: NumberField): Live {
  const { path, unit, step, means = unit } = field;
  const input = element("input", {
    type: "text",
    inputmode: "decimal",
    class: "number",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: field.usual ?? (field.needed === true ? "?" : null),
  });
  const why = element("p", { class: "why", role: "alert", id: newId(), hidden: true });
  let gesture = newId();
  let given: number | undefined;
  /** What the scene had before somebody typed. */
  let before: number | undefined;
  let comma = false;

  const refuse = (message: string | null): void => {
    input.classList.toggle("unread", message !== null);
    why.textContent = message ?? "";
    why.hidden = message === null;
    if (message === null) input.removeAttribute("aria-describedby");
    else input.setAttribute("aria-describedby", why.id);
  };
  const take = (value: number | undefined): void => {
    if (value === given) return;
    given = value;
    void edit(app, [put(path, value)], gesture);
  };
  /** Takes what stands there as far as it is a number; why it is none is said when nobody types any more. */
  const read = (isPaused: boolean): void => {
    const text = input.value.trim();
    const value = text === "" ? undefined : measured(text, means);
    const why = unreadable(value);
    if (why === null || isPaused) refuse(why);
    take(why === null ? (value as number | undefined) : before);
  };
  /** Why this is no value of the field; null where it is one. */
  const unreadable = (value: ReturnType<typeof measured> | undefined): string | null => {
    if (value === undefined) return field.needed === true ? say("needed") : null;
    if (value === null) return say("unread");
    if (typeof value === "object") return means === "" ? say("unread") : say("other_unit", { unit: value.unit, own: means });
    return field.least !== undefined && value < field.least ? say("least", { least: field.least }) : null;
  };
  const go = (steps: number): void => {
    const now = measured(input.value, means);
    const next = stepped(typeof now === "number" ? now : (given ?? 0), step, steps);
    const value = Math.max(next, field.least ?? -Infinity);
    input.value = shownNumber(value, comma);
    refuse(null);
    take(value);
  };
  const revert = (): void => {
    input.value = given === undefined ? "" : shownNumber(given, comma);
    refuse(null);
  };

  const begin = (): void => {
    gesture = newId();
    if (!input.classList.contains("unread")) before = given;
  };
  input.addEventListener("focus", begin);
  const typist = typing(app, read);
  input.addEventListener("input", typist.typed);
  input.addEventListener("blur", () => (typist.paused(), input.classList.contains("unread") || revert()));
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") typist.paused();
    const steps = (KEYS[event.key] ?? 0) * (event.shiftKey ? 10 : 1) * (event.altKey ? 0.1 : 1);
    if (steps !== 0) go(steps);
    else if (event.key === "Enter") input.classList.contains("unread") || revert(), input.select(), begin();
    else if (event.key === "Escape" && input.classList.contains("unread")) revert();
    else return;
    event.preventDefault();
  });
  // Only over the field that has the focus: else a page that is scrolled would change numbers.
  input.addEventListener("wheel", (event) => {
    if (document.activeElement !== input || event.deltaY === 0) return;
    event.preventDefault();
    go(event.deltaY < 0 ? 1 : -1);
  }, { passive: false });

  const root = labelled(field, input, element("span", { class: "unit" }, unit), ...(field.pin === undefined ? [] : [pinButton(app, field.pin)]));
  root.append(why);
  return {
    root,
    show(scene) {
      const value = at(scene, path);
      const next = typeof value === "number" ? value : undefined;
      const mark = at(scene, ["figure", "decimal"]) === "comma";
      const stays = next === given && mark === comma && (document.activeElement === input || input.classList.contains("unread"));
      comma = mark;
      if (stays) return;
      given = next;
      // What is being typed stays as it is typed.
      if (document.activeElement === input && next !== undefined && measured(input.value, means) === next) return;
      revert();
    },
  };
}
