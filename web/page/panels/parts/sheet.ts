/** A form on the page: built from its description, kept current, with messages at their fields. */
import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import type { Refused } from "../../engine/types.ts";
import { language } from "../../words.ts";
import { edit } from "./edits.ts";
import { fieldOf, nameInput, newId, type Live } from "./fields.ts";
import type { Ask, Button, Card, Form, Group, Row } from "./form.ts";
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
  const state: State = { app, owner, live: [], open: new Map() };
  const body = element("div", { class: "form" });
  const waits = element("div", { class: "waits", role: "status", hidden: true }, element("p", {}, ""), element("button", { type: "button" }, ""));
  waits.querySelector("button")!.addEventListener("click", () => app.show("text"));
  root.append(waits, body);
  body.addEventListener("keydown", (event) => undone(app, event));
  let shape = "";
  const current = (): void => {
    const scene = parsed(app.history.now.value.text);
    waits.hidden = scene !== null;
    body.inert = scene === null;
    waits.querySelector("p")!.textContent = say("unreadable");
    waits.querySelector("button")!.textContent = say("mend");
    if (scene === null) return;
    const form = owner.describe(scene);
    const next = language.value + JSON.stringify(form);
    if (next !== shape) rebuilt(body, state, form);
    shape = next;
    for (const live of state.live) live.show(scene);
  };
  app.history.now.on(current);
  language.on(current);
  app.solved.on(({ text, refused }) => {
    current();
    const isPresent = text === app.history.now.value.text;
    placeMessage(body, isPresent ? refused : null);
  });
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
  live: Live[];
  /** Groups that somebody opened or closed. */
  open: Map<string, boolean>;
}

/** Builds the form anew; the focus stays where it was. */
function rebuilt(body: HTMLElement, state: State, form: Form): void {
  const focus = placesOfFocus(body);
  state.live = [];
  body.replaceChildren(...form.groups.map((group) => groupOf(state, group)));
  for (const { selector, index } of focus) {
    const again = body.querySelectorAll<HTMLElement>(selector)[index];
    if (again === undefined) continue;
    again.focus({ preventScroll: true });
    return;
  }
}

/**
 * Where the focus is, for the form that is built anew: the same field or button; where that is gone, the first of what it was in, from
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
  const inner = element(
    "div",
    { class: "inner" },
    group.help !== undefined && element("p", { class: "help" }, group.help),
    ...(group.cards ?? []).map((card) => cardOf(state, card)),
    ...(group.rows ?? []).map((row) => rowOf(state, row)),
    buttonsOf(state, group.buttons),
  );
  const given = { class: "group", "data-path": group.path === undefined ? null : dotted(group.path) };
  if (group.folded === undefined) return element("section", given, element("h3", {}, group.title), inner);
  const details = element("details", { ...given, open: state.open.get(group.id) ?? !group.folded }, element("summary", {}, element("h3", {}, group.title)), inner);
  details.addEventListener("toggle", () => state.open.set(group.id, details.open));
  return details;
}

function cardOf(state: State, card: Card): HTMLElement {
  const heading = element(
    "header",
    {},
    element("h4", {}, card.title),
    card.name !== undefined && nameInput(state.app, card.name),
    card.role !== undefined && element("span", { class: "role" }, card.role),
    buttonsOf(state, card.buttons),
  );
  return element("article", { class: "card", "data-path": dotted(card.path), "aria-label": `${card.title} ${card.name?.name ?? ""}` }, heading, ...card.rows.map((row) => rowOf(state, row)));
}

function rowOf(state: State, row: Row): HTMLElement {
  const fields = row.fields.map((field) => fieldOf(state, field));
  state.live.push(...fields);
  return element(
    "div",
    { class: row.titled === true ? "row titled" : row.aligned === true ? "row aligned" : "row", role: "group", "aria-label": row.label ?? row.name?.name, "data-path": row.path === undefined ? null : dotted(row.path) },
    row.label !== undefined && element("span", { class: "of" }, row.label),
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
