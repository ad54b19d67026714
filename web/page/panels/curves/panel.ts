import type { App, Panel } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { button, tick, worded } from "../../dom/worded.ts";
import type { Curves } from "../../engine/types.ts";
import { fileName, saveFile } from "../../files/save.ts";
import { orTell, said } from "../../refused.ts";
import { signal, type Signal } from "../../state/signal.ts";
import { language } from "../../words.ts";
import { keepCurrent } from "../output/current.ts";
import { ENDINGS, type FileFormat, fileOf, PICTURES, TYPES } from "../output/formats.ts";
import { oneOf } from "../output/one_of.ts";
import { sheet } from "../output/sheet.ts";
import { type Choice, columnsOf, fitted, type Kind, KINDS, offered, offeredNames, tracedOf, wantedOf } from "./choice.ts";
import { choices, points, ticked } from "./chooser.ts";
import { follow } from "./follow.ts";
import { place } from "./place.ts";
import { fewDigits } from "../values/text.ts";
import { say } from "./words.ts";

/** Curves of quantities, hodographs of vectors and paths of points over the cycle. */
export const curves: Panel = {
  id: "curves",
  title: () => say("panel_title"),
  mount(root, app) {
    const choice = signal<Choice>({ kind: "curves", names: { curves: [], hodograph: [], path: [] }, beyond: false });
    const drawn = element("p", {});
    worded(drawn, () => say("drawn"));
    const contents = element("div", {}, chooser(app, choice), picture(app, choice));
    root.append(drawn, contents);
    app.solved.on(({ opened }) => {
      if (opened === null) return;
      drawn.hidden = !opened.is_drawn;
      contents.hidden = opened.is_drawn;
      choice.set(fitted(choice.value, opened));
    });
    // The paths are in the picture of the mechanism, too, as long as somebody looks at curves.
    const trace = (): void => {
      const { opened } = app.solved.value;
      const next = opened === null || opened.is_drawn || app.shown.value !== curves.id ? [] : tracedOf(choice.value, opened);
      if (next.join("\n") !== app.traced.value.join("\n")) app.traced.set(next);
    };
    for (const one of [app.solved, app.shown, choice] as Pick<Signal<unknown>, "on">[]) one.on(trace);
  },
};

type Chosen = Signal<Choice>;

/** What to draw: its kind, and names to tick. */
function chooser(app: App, choice: Chosen): HTMLElement {
  const kind = signal<Kind>("curves");
  kind.on((now) => choice.set({ ...choice.value, kind: now }));
  const kinds = oneOf(kind, KINDS, () => say("what"), (value) => say(value));
  const names = element("div");
  const beyond = tick(() => say("beyond"), (on) => choice.set({ ...choice.value, beyond: on }));
  const clear = button(() => say("clear"), () => {
    const { kind } = choice.value;
    choice.set({ ...choice.value, names: { ...choice.value.names, [kind]: [] } });
  }, { class: "framed" });
  const summary = element("summary");
  const fold = element("details", { open: true }, summary, names, clear);

  function toggle(name: string, on: boolean): void {
    const { kind, names } = choice.value;
    const others = names[kind].filter((other) => other !== name);
    choice.set({ ...choice.value, names: { ...names, [kind]: on ? [...others, name] : others } });
  }
  let listed = "";
  /** Lists anew what can be ticked, where that is other than what stands there; ticks what is chosen. */
  function list(): void {
    const { opened } = app.solved.value;
    const { kind, names: chosen } = choice.value;
    summary.textContent = `${say("choose")}: ${chosen[kind].join(", ")}`;
    beyond.label.hidden = kind !== "path";
    if (opened === null) return;
    const all = offered(opened);
    const now = [language.value, kind, ...offeredNames(all)[kind]].join("\n");
    if (now === listed) return ticked(names, chosen[kind]);
    listed = now;
    names.replaceChildren(kind === "path" ? points(all.path, chosen.path, toggle) : choices(all[kind], chosen[kind], toggle, () => ticked(names, choice.value.names[kind])));
  }
  choice.on(() => list());
  language.on(() => list());
  return element("div", { class: "chooser" }, kinds.root, fold, beyond.label);
}

/** The picture with its events, and ways to save it. */
function picture(app: App, choice: Chosen): HTMLElement {
  let shown: Curves | null = null;
  const message = element("p", { role: "alert", class: "bad" });
  const drawing = sheet(false);
  follow(app, drawing, () => shown);
  const room = element("div");
  const pane = place(app, curves.id, room, drawing.root);
  const events = element("ul", { class: "events" });
  function save(format: FileFormat): Promise<void> {
    const of = format === "csv" ? { curves: columnsOf(choice.value) } : wantedOf(choice.value);
    const name = `${fileName(app.solved.value.opened?.title)}-${choice.value.kind}.${ENDINGS[format]}`;
    return orTell(app, async () => saveFile(name, await fileOf(app, format, of), TYPES[format]));
  }
  const saves = PICTURES.map(([format, title]) => {
    const made = button(() => title, () => void save(format));
    return worded(made, () => say("save", { format: title }), "aria-label");
  });
  const tools = element("div", { class: "tools" }, ...saves);
  tools.append(worded(button(() => "CSV", () => void save("csv")), () => say("table"), "aria-label"));

  keepCurrent(app, curves.id, [app.solved, choice, language, pane], async () => {
    const { good, opened } = app.solved.value;
    if (opened === null || opened.is_drawn) return;
    const isNothing = choice.value.names[choice.value.kind].length === 0;
    try {
      shown = isNothing ? null : await app.engine.curves(good, wantedOf(choice.value), pane.value);
      message.textContent = isNothing ? say("none") : "";
    } catch (refused) {
      // The last good picture stays.
      message.textContent = said(refused);
    }
    tools.hidden = drawing.root.hidden = shown === null;
    if (shown === null) return;
    drawing.show(shown.svg);
    const lines = shown.events.length > 0 ? shown.events : [say("no_events")];
    events.replaceChildren(...lines.map((text) => element("li", {}, fewDigits(text))));
  });
  return element("div", {}, message, room, tools, worded(element("h3"), () => say("events")), events);
}
