import { element } from "../../../dom/element.ts";
import { shownNumber } from "../../../number.ts";
import { language } from "../../../words.ts";
import { called, DRAWN_ON } from "../../../sheets.ts";
import { keyOf } from "./placing.ts";
import { plain } from "./points_bar.ts";
import type { FormOf, Item, Session } from "./session.ts";
import { kindOf } from "./stage.ts";
import { say } from "./words.ts";

/** What comes next: in words, as HTML of the page's words and the engine's labels; how; and buttons for it. */
export interface Prompt {
  html: string;
  how: string;
  actions: HTMLElement[];
}

/** What the buttons do. */
export interface Acts {
  choose(key: string): void;
  accept(all: Item[]): void;
  leaveOut(one: Item): void;
  remove(one: Item): void;
  toResult(): void;
  /** Takes the points to the drawing board. */
  toBoard(): void;
  /** Asks for another photograph. */
  another(): void;
}

/** Millimetres as they are read. */
export const millimetres = (mm: number): string => shownNumber(Number(mm.toFixed(1)), language.value !== "en");

export function button(text: string, press: () => void, isMain = false): HTMLButtonElement {
  return element("button", { type: "button", class: isMain ? "main" : "", onclick: press }, text);
}

const isTouched = (): boolean => window.matchMedia("(pointer: coarse)").matches;

/** What comes next with a photograph; `note` is what was last to be told. */
export function prompt(own: Session, form: FormOf, acts: Acts, note: string): Prompt {
  const one = own.item(own.chosen);
  return one === undefined ? finished(own, form, acts, note) : ofPoint(own, one, acts, note);
}

function ofPoint(own: Session, one: Item, acts: Acts, note: string): Prompt {
  const name = one.label;
  const onward = own.next(one.key);
  const forward = onward === "" ? button(say("see_check"), acts.toResult, true) : button(say("next"), () => acts.choose(onward), true);
  const mark = own.marks.find((of) => keyOf(of.plan, of.name) === one.key);
  if (mark !== undefined) {
    const kind = kindOf(mark);
    const mm = millimetres(mark.off);
    const how = note !== "" ? note : kind === "open" ? say("open_how", { mm }) : say(isTouched() ? "move_touch" : "move_how");
    return { html: say(`is_${kind}`, { name, mm }), how, actions: [button(say("take_away", { name: plain(name) }), () => acts.remove(one)), forward] };
  }
  if (one.isPole) return { html: say("at_printed", { name }), how: note !== "" ? note : say(isTouched() ? "move_touch" : "move_how"), actions: [forward] };
  const isGuessed = own.guessOf(one) !== undefined;
  const isBoth = own.photo.plans.length > 1;
  const html = say(isGuessed ? (isBoth ? "is_here_in" : "is_here") : isBoth ? "tap_in" : "tap", { name, plan: called(one.plan.plan, "name") });
  const skip = button(say("leave_out", { name: plain(name) }), () => acts.leaveOut(one));
  const guessed = own.items.filter((of) => own.guessOf(of) !== undefined);
  if (!isGuessed) {
    const usual = say(own.isLooking ? "looking" : isTouched() ? "tap_how" : "tap_mouse");
    return { html, how: note !== "" ? note : usual, actions: [skip, ...acceptAll(guessed, acts)] };
  }
  const accept = button(say("accept", { name: plain(name) }), () => acts.accept([one]), true);
  return { html, how: note !== "" ? note : say("proposed_how"), actions: [skip, ...acceptAll(guessed, acts), accept] };
}

function acceptAll(guessed: Item[], acts: Acts): HTMLElement[] {
  return guessed.length < 2 ? [] : [button(say("accept_all", { count: guessed.length }), () => acts.accept(guessed))];
}

function finished(own: Session, form: FormOf, acts: Acts, note: string): Prompt {
  const states = own.items.filter(({ isPole }) => !isPole).map(own.stateOf);
  const counted = (["right", "off", "open", "out"] as const).map((state) => ({ state, count: states.filter((of) => of === state).length }));
  const counts = counted.filter(({ count }) => count > 0).map(({ state, count }) => say(`count_${state}`, { count }));
  const here = new Set(own.photo.plans.map(({ plan }) => plan));
  const points = form.form()?.points;
  const marked = form.present().points;
  const missing = DRAWN_ON.find((plan) => !here.has(plan) && (points?.[plan]?.length ?? 0) > 1 && marked?.[plan] === undefined);
  const further = missing === undefined ? [] : [button(say("other_plan", { plan: called(missing, "name") }), acts.another)];
  const html = say(states.includes("out") ? "none_left" : "all_marked");
  return { html, how: note !== "" ? note : counts.join(", "), actions: [...further, button(say("on_board"), acts.toBoard), button(say("see_check"), acts.toResult, true)] };
}
