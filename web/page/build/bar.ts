/** The tools above the stage, and the line below it: what to do, and what is missing. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { radios } from "../dom/radios.ts";
import { worded } from "../dom/worded.ts";
import { askedFor } from "../files/open.ts";
import { unitsOf } from "../panels/parts/scene.ts";
import { measured } from "../units.ts";
import { language } from "../words.ts";
import { photographed, scaled } from "./ground.ts";
import { unfinished } from "./mobility.ts";
import { NOTHING, type Model } from "./model.ts";
import type { Pixels } from "./sight.ts";
import { GUIDED, KEY_OF, SLIDING, TOOLS } from "./tools.ts";
import { say, type Saying } from "./words.ts";

const PICTURES = "image/*";

/** One of several, as buttons; `key` is that which chooses it on the stage. */
function choice<Value extends string>(values: readonly Value[], called: (value: Value) => Saying, name: Saying, key: (index: number) => string, choose: (value: Value) => unknown): { root: HTMLElement; mark(now: Value): void } {
  const buttons = values.map((value) => {
    const button = worded(element("button", { type: "button", role: "radio", "data-value": value, onclick: () => choose(value) }), () => say(called(value)));
    // A tap right after a drag on the stage may come without a click.
    button.addEventListener("pointerup", ({ pointerType }) => pointerType === "touch" && choose(value));
    return button;
  });
  const root = element("div", { class: "switch", role: "radiogroup" }, ...buttons);
  radios(root);
  language.on(() => {
    root.setAttribute("aria-label", say(name));
    buttons.forEach((button, index) => (button.title = say("key", { key: key(index) })));
  });
  return {
    root,
    mark: (now) =>
      buttons.forEach((button, index) => {
        button.setAttribute("aria-checked", String(values[index] === now));
        button.tabIndex = values[index] === now ? 0 : -1;
      }),
  };
}

/** The rows of tools; `back` gives the focus back to the stage. */
export function toolRows(app: App, model: Model, back: () => void): HTMLElement {
  const then = (act: () => void) => (): void => {
    act();
    back();
  };
  const button = (called: () => string, act: () => void): HTMLButtonElement => worded(element("button", { type: "button", onclick: act }), called);
  const tools = choice(TOOLS, (tool) => `tool_${tool}`, "tools", (index) => String(index + 1), (tool) => {
    void model.inTurn(() => {
      model.begun.set(null);
      model.tool.set(tool);
    });
    if (!tools.root.matches(":focus-within:has(:focus-visible)")) back();
  });
  const sliding = choice(SLIDING, (what) => `slides_${what}`, "what_slides", () => KEY_OF.sliding, (what) => model.inTurn(() => model.choices.set({ ...model.choices.value, sliding: what })));
  const guided = choice(GUIDED, (how) => `guided_${how}`, "on_link", () => KEY_OF.guided, (how) => model.inTurn(() => model.choices.set({ ...model.choices.value, guided: how })));
  const choices = element("div", { class: "choices" }, sliding.root, guided.root);
  const snaps = button(() => say("snap"), then(() => model.snaps.set(!model.snaps.value)));
  const middle = (): Pixels => [model.sight.size.width / 2, model.sight.size.height / 2];
  const out = button(() => "−", then(() => model.sight.zoom(0.8, middle())));
  const whole = button(() => say("fit"), then(() => model.fit()));
  const nearer = button(() => "+", then(() => model.sight.zoom(1.25, middle())));
  language.on(() => {
    out.setAttribute("aria-label", say("smaller"));
    nearer.setAttribute("aria-label", say("larger"));
  });
  const seen = element("div", { class: "seen" }, snaps, photoButtons(app, model, back), out, whole, nearer);
  const root = element("div", { class: "tools" }, tools.root, element("div", { class: "second" }, choices, seen));

  model.tool.on((tool) => {
    tools.mark(tool);
    choices.hidden = tool !== "slider";
    if (tool !== "select") model.chosen.set(NOTHING);
  });
  model.choices.on((now) => (sliding.mark(now.sliding), guided.mark(now.guided)));
  const told = (): void => {
    snaps.setAttribute("aria-pressed", String(model.snaps.value));
    const unit = unitsOf(model.present()?.scene ?? {}).length;
    snaps.textContent = `${say("snap")} ${model.sight.grid().fine} ${unit}`;
  };
  model.snaps.on(told);
  model.sight.now.on(told);
  model.shown.on(told);
  language.on(told);
  return root;
}

/** A photograph behind the mechanism: chosen, set to scale by two of its places, taken away. */
function photoButtons(app: App, model: Model, back: () => void): HTMLElement {
  const choose = worded(element("button", { type: "button" }), () => say("photo"));
  const scale = worded(element("button", { type: "button" }), () => say("photo_scale"));
  const away = worded(element("button", { type: "button" }), () => say("photo_away"));
  const length = element("input", { type: "text", inputmode: "decimal", class: "length", autocomplete: "off" });
  const root = element("span", { class: "photo" }, choose, scale, length, away);
  choose.onclick = () =>
    void askedFor(PICTURES).then(async (file) => {
      if (file === null) return;
      try {
        model.photo.set(await photographed(file, model.sight));
        model.scaling.set([]);
      } catch {
        app.tell(say("photo_unread"));
      }
      back();
    });
  scale.onclick = () => {
    model.scaling.set([]);
    back();
  };
  away.onclick = () => {
    if (model.photo.value !== null) URL.revokeObjectURL(model.photo.value.address);
    model.photo.set(null);
    model.scaling.set(null);
    back();
  };
  length.onkeydown = (event) => {
    event.stopPropagation();
    const [first, second] = model.scaling.value ?? [];
    if (event.key === "Escape") model.scaling.set(null);
    if (event.key !== "Enter" || first === undefined || second === undefined || model.photo.value === null) return;
    const unit = unitsOf(model.present()?.scene ?? {}).length;
    const value = measured(length.value, unit);
    if (typeof value !== "number" || !(value > 0)) return app.tell(say("photo_number", { unit }));
    model.photo.set(scaled(model.photo.value, [first, second], value));
    model.scaling.set(null);
    model.fit();
    back();
  };
  const told = (): void => {
    const has = model.photo.value !== null;
    choose.hidden = has;
    scale.hidden = away.hidden = !has;
    const wasHidden = length.hidden;
    length.hidden = (model.scaling.value?.length ?? 0) < 2;
    length.placeholder = say("photo_length");
    length.setAttribute("aria-label", say("photo_length"));
    if (wasHidden && !length.hidden) {
      length.value = "";
      length.focus();
    }
  };
  model.photo.on(told);
  model.scaling.on(told);
  language.on(told);
  return root;
}

/** What to do, and whether the mechanism is complete. */
export function stateLine(app: App, model: Model): HTMLElement {
  const hint = element("p", { class: "hint" });
  const state = element("p", { class: "state", role: "status", id: "build-state" });
  const told = (): void => {
    if (!app.building.value) return;
    const { begun, tool, scaling, note } = model;
    hint.textContent = scaling.value !== null ? say("photo_two") : begun.value !== null ? say("second") : say(`hint_${tool.value}`);
    const { refused, text } = app.solved.value;
    const isCurrent = text === app.history.now.value.text;
    state.classList.toggle("complete", isCurrent && refused === null);
    if (note.value !== "") state.textContent = note.value;
    else if (isCurrent) state.textContent = refused === null ? say("complete") : unfinished(model.present()?.scene ?? {}, refused);
  };
  for (const each of [model.tool, model.begun, model.scaling, model.note, model.shown, app.solved, app.building, language] as { on(act: () => void): void }[]) each.on(told);
  return element("div", { class: "foot" }, hint, state);
}
