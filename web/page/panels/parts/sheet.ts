/** A form on the page: built from its description, kept current, with messages at their fields. */
import type { App } from "../../app.ts";
import { isBegun } from "../../build/mobility.ts";
import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import type { Refused } from "../../engine/types.ts";
import { language } from "../../words.ts";
import { edit } from "./edits.ts";
import { fieldOf, nameInput, newId, type Live } from "./fields.ts";
import type { Adder, Ask, Button, Card, Form, Group, Row } from "./form.ts";
import { pieces, settled, type Pieces } from "./pieces.ts";
import { dotted, parsed, type Draft } from "./scene.ts";
import { say } from "./words.ts";

/** What the owner of a form does. */
export interface Owner {
  /** The form of a scene. */
  describe(scene: Draft): Form;
  /** Does what a button or a choice with `ask` asks for. */
  asked?(ask: Ask): void;
}

/** Keeps a form of the scene in `root`; `again` describes it anew, for what is not in the scene. */
export function keepForm(root: HTMLElement, app: App, owner: Owner): { again(): void } {
  const body = element("div", { class: "form" });
  const waits = element("div", { class: "waits", role: "status", hidden: true }, element("p", {}, ""), element("button", { type: "button" }, ""));
  waits.querySelector("button")!.addEventListener("click", () => app.show("text"));
  root.append(waits, body);
  body.addEventListener("keydown", (event) => undone(app, event));
  const current = (): void => {
    const scene = parsed(app.history.now.value.text);
    waits.hidden = scene !== null;
    body.inert = scene === null;
    waits.querySelector("p")!.textContent = say("unreadable");
    waits.querySelector("button")!.textContent = say("mend");
    if (scene === null) return;
    const focus = placesOfFocus(body);
    settled(body, owner.describe(scene).groups.map((group) => groupOf(state, group)));
    state.pieces.show(scene);
    if (!body.contains(document.activeElement)) focusAgain(body, focus);
  };
  const state: State = { app, owner, pieces: pieces(body, current), open: new Map(), again: current };
  app.history.now.on(current);
  language.on(() => {
    state.pieces.clear();
    current();
  });
  // Nothing is wrong with what is only begun: Build says what is missing, and the bar over the picture.
  const message = (): void => {
    const { text, refused } = app.solved.value;
    const isMistake = refused !== null && text === app.history.now.value.text && !app.building.value && !isBegun(parsed(text) ?? {}, refused);
    placeMessage(body, isMistake ? refused : null);
  };
  app.solved.on(() => {
    current();
    message();
  });
  app.building.on(message);
  return { again: current };
}

/** Undo in a field is the document's: what the field shows follows. */
function undone(app: App, event: KeyboardEvent): void {
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y")) return;
  event.preventDefault();
  event.stopPropagation();
  if (key === "y" || event.shiftKey) app.history.redo();
  else app.history.undo();
}

interface State {
  app: App;
  owner: Owner;
  pieces: Pieces;
  /** Groups and cards that somebody opened or closed. */
  open: Map<string, boolean>;
  again(): void;
}

/** Puts the focus where it was in a form of which parts were built anew. */
function focusAgain(body: HTMLElement, focus: { selector: string; index: number }[]): void {
  for (const { selector, index } of focus) {
    const again = body.querySelectorAll<HTMLElement>(selector)[index];
    if (again === undefined) continue;
    again.focus({ preventScroll: true });
    return;
  }
}

/**
 * Where the focus is, for what is built anew: the same field or button; where that is gone, the first of what it was in, from
 * the inside out.
 */
function placesOfFocus(body: HTMLElement): { selector: string; index: number }[] {
  const element = document.activeElement;
  if (!(element instanceof HTMLElement) || !body.contains(element)) return [];
  const places: { selector: string; index: number }[] = [];
  for (let outer = element.closest<HTMLElement>("[data-path]"); outer !== null; outer = outer.parentElement?.closest<HTMLElement>("[data-path]") ?? null) {
    const own = `[data-path="${CSS.escape(outer.dataset["path"]!)}"]`;
    if (places.length === 0) {
      const selector = `${own} ${element.localName}`;
      places.push({ selector, index: [...body.querySelectorAll(selector)].indexOf(element) });
    }
    places.push({ selector: `${own} :is(input, select, button)`, index: 0 });
  }
  return [...places, { selector: "input, select, button", index: 0 }];
}

function groupOf(state: State, group: Group): HTMLElement {
  const { pieces } = state;
  const root = pieces.of(group.id, [group.title, group.folded, group.path], () => frame(state, group));
  const inner = root.querySelector<HTMLElement>(":scope > .inner")!;
  const help = group.help === undefined ? [] : [pieces.of(`${group.id} help`, group.help, () => element("p", { class: "help" }, group.help))];
  const cards = (group.cards ?? []).map((card, index) => {
    const key = dotted(card.path);
    return pieces.isNear(key, index) ? built(state, key, card) : pieces.later(key, key);
  });
  const rows = (group.rows ?? []).map((row, index) => {
    const path = dotted(row.path ?? row.fields[0]?.path ?? []);
    const key = `${group.id} ${path === "" ? index : path}`;
    return pieces.isNear(key, index) ? pieces.of(key, row, (live) => rowOf(state, row, live)) : pieces.later(key, path);
  });
  const buttons = group.buttons === undefined ? [] : [pieces.of(`${group.id} buttons`, group.buttons, () => buttonsOf(state, group.buttons)!)];
  settled(inner, [...help, ...cards, ...rows, ...buttons]);
  const { adder } = group;
  if (adder !== undefined) settled(root.querySelector<HTMLElement>(":scope > header > .adding")!, [pieces.of(`${group.id} adder`, adder, (live) => alone(state, adder, live))]);
  return root;
}

/** A group with nothing in it yet. */
function frame(state: State, group: Group): HTMLElement {
  const inner = element("div", { class: "inner" });
  const given = { class: "group", "data-path": group.path === undefined ? null : dotted(group.path) };
  if (group.folded === undefined) return element("section", given, element("header", {}, element("h3", {}, group.title), element("div", { class: "adding" })), inner);
  const details = element("details", { ...given, open: state.open.get(group.id) ?? !group.folded }, element("summary", {}, element("h3", {}, group.title)), inner);
  details.addEventListener("toggle", () => state.open.set(group.id, details.open));
  return details;
}

function built(state: State, key: string, card: Card): HTMLElement {
  const line = card.line();
  const rows = state.open.get(key) === true ? card.rows() : null;
  return state.pieces.of(key, [card, line, rows], (live) => cardOf(state, key, card, { line, rows, live }));
}

function cardOf(state: State, key: string, card: Card, { line, rows, live }: { line: Row[]; rows: Row[] | null; live: Live[] }): HTMLElement {
  const title = `${card.title} ${card.name?.name ?? ""}`.trim();
  const more = element("button", { type: "button", class: "bare more", "aria-label": say("more", { title }), title: say("more", { title }), "aria-expanded": String(rows !== null) }, icon("forward"));
  more.addEventListener("click", () => {
    state.open.set(key, rows === null);
    state.again();
  });
  const heading = element(
    "header",
    {},
    more,
    element("h4", { class: card.name === undefined ? null : "unseen" }, title),
    card.name !== undefined && nameInput(state.app, card.name),
    element("div", { class: "line" }, card.role !== undefined && element("span", { class: "role" }, card.role), ...line.map((row) => rowOf(state, row, live))),
    buttonsOf(state, card.buttons),
  );
  return element("article", { class: "card", "data-path": key, "aria-label": title }, heading, ...(rows ?? []).map((row) => rowOf(state, row, live)));
}

function alone(state: State, field: Adder, live: Live[]): HTMLElement {
  const made = fieldOf(state, field);
  live.push(made);
  return made.root;
}

function rowOf(state: State, row: Row, live: Live[]): HTMLElement {
  const fields = row.fields.map((field) => fieldOf(state, field));
  live.push(...fields);
  return element(
    "div",
    { class: row.titled === true ? "row titled" : row.aligned === true ? "row aligned" : "row", role: "group", "aria-label": row.label ?? row.name?.name, "data-path": row.path === undefined ? null : dotted(row.path) },
    row.label !== undefined && row.quiet !== true && element("span", { class: "of" }, row.label),
    row.name !== undefined && nameInput(state.app, row.name),
    ...fields.map(({ root }) => root),
    buttonsOf(state, row.buttons),
  );
}

function buttonsOf(state: State, buttons: Button[] | undefined): HTMLElement | null {
  if (buttons === undefined || buttons.length === 0) return null;
  return element("div", { class: "buttons" }, ...buttons.map((button) => buttonOf(state, button)));
}

function buttonOf({ app, owner }: State, { text, icon: drawn, edits, ask, pressed }: Button): HTMLElement {
  const isIcon = drawn === "remove" || drawn === "pin";
  const button = element(
    "button",
    { type: "button", class: drawn === "pin" ? "pin" : isIcon ? "bare" : "small", "aria-pressed": pressed === undefined ? null : String(pressed), "aria-label": isIcon ? text : null, title: isIcon ? text : null },
    drawn !== undefined && icon(drawn),
    isIcon ? null : text,
  );
  button.addEventListener("click", () => {
    if (ask !== undefined) owner.asked?.(ask);
    if (edits !== undefined) void edit(app, edits).then((refused) => refused !== null && app.tell(refused.message));
  });
  return button;
}

/** Shows why the scene is refused at the field that it is about. */
function placeMessage(body: HTMLElement, refused: Refused | null): void {
  for (const old of body.querySelectorAll(".refusal")) old.remove();
  for (const field of body.querySelectorAll("[aria-invalid=true][aria-errormessage]")) {
    field.removeAttribute("aria-invalid");
    field.removeAttribute("aria-errormessage");
  }
  if (refused === null || refused.path === "") return;
  const places = [...body.querySelectorAll<HTMLElement>("[data-path]")];
  const length = (place: HTMLElement): number => place.dataset["path"]!.length;
  const path = refused.path.replaceAll(/\[(\d+)\]/g, ".$1");
  const about = places.filter((place) => `${path}.`.startsWith(`${place.dataset["path"]}.`)).sort((a, b) => length(b) - length(a))[0];
  if (about === undefined) return;
  const message = element("p", { class: "refusal", id: newId() }, refused.message, refused.hint !== null && element("span", { class: "hint" }, ` ${refused.hint}`));
  about.append(message);
  const input = about.matches(".field") ? about.querySelector("input, select") : null;
  input?.setAttribute("aria-invalid", "true");
  input?.setAttribute("aria-errormessage", message.id);
}
