import type { App } from "../../../app.ts";
import { element } from "../../../dom/element.ts";
import { byId } from "../../../dom/find.ts";
import type { Form, Photo, PhotoPlan, Tapped } from "../../../engine/types.ts";
import { askedFor } from "../../../files/open.ts";
import { undo } from "../../../layout/keys.ts";
import { shownNumber } from "../../../number.ts";
import { newest } from "../../../state/newest.ts";
import { signal, type Signal } from "../../../state/signal.ts";
import { language } from "../../../words.ts";
import type { FormFile } from "../form.ts";
import { frame } from "./frame.ts";
import { loupe } from "./loupe.ts";
import { greyOf, type Photograph, photograph, turned } from "./picture.ts";
import { keyOf, placesOn, planOf, withoutPoint, withPoint, withTapped } from "./placing.ts";
import { type Entry, plain, pointsBar, type State } from "./points_bar.ts";
import { refusedBy, type Why } from "./refusals.ts";
import { boxOf, kindOf, type Mark, type Pixel, stage } from "./stage.ts";
import { touch } from "./touch.ts";
import { say } from "./words.ts";

/** What the photograph asks of the form. */
export interface FormOf {
  change(how: (file: FormFile) => FormFile, gesture: string): void;
  left(): void;
  present(): FormFile;
  form(): Form | null;
  /** Goes to what the check says. */
  toResult(): void;
}

export interface PhotoView {
  isShown: Signal<boolean>;
  /** Whether there is a photograph to go back to. */
  isThere: Signal<boolean>;
  /** Takes a file that somebody brings. */
  open(file: File): Promise<void>;
  show(): void;
  hide(): void;
  /** The form has changed. */
  follow(): void;
}

/** A point of a plan on the sheet. */
interface Item {
  key: string;
  plan: PhotoPlan;
  name: string;
  label: string;
  isPole: boolean;
}

/** Narrower than this the photograph fills the screen, as panels stand below the picture. */
const NARROW = "(max-width: 959.9px)";
/** How far arrow keys go, in mm; with Shift. */
const [STEP, LARGE] = [0.1, 1];

/** A photograph of the student's drawing in place of the picture: the right plan over it, points that are tapped go into the form. */
export function photoView(app: App, form: FormOf): PhotoView {
  const isShown = signal(false);
  const isThere = signal(false);
  let picture: Photograph | null = null;
  let photo: Photo | null = null;
  /** The scene that the photograph was read for. */
  let scene = "";
  let why: Why | null = null;
  let busy: "opening" | "reading" | null = null;
  let chosen = "";
  let leftOut = new Set<string>();
  let marks: Mark[] = [];
  /** Radii of places as the photograph gave them, while the form has the same place. */
  const bands = new Map<string, { at: string; band: number }>();
  /** Points that are proposed, until somebody accepts them or taps elsewhere. */
  let guesses = new Map<string, Tapped>();
  let wantsRight = true;
  let note = "";
  /** Where somebody aims who has the keyboard alone. */
  let cursor: Pixel = [0, 0];
  let opener: Element | null = null;

  const table = stage();
  const glass = loupe(table);
  const aim = element("button", { type: "button", class: "aim" });
  table.root.append(aim, glass.root);
  const bar = pointsBar((key) => choose(key));
  const shell = frame(table.root, bar.root, {
    close: hide,
    right: toggleRight,
    undo: () => undo(app),
    zoom: (factor) => table.view.zoom(factor, [table.view.size.width / 2, table.view.size.height / 2]),
    fit: () => table.view.refit(),
  });
  byId("main").append(shell.root);
  const { root } = shell;

  const items = (): Item[] =>
    (photo?.plans ?? []).flatMap((plan) => plan.points.map(({ name, label }, index) => ({ key: keyOf(plan.plan, name), plan, name, label, isPole: index === 0 })));
  const item = (key: string): Item | undefined => items().find((one) => one.key === key);
  const placeOf = ({ plan, name }: Item): [number, number, number?] | undefined => placesOn(form.present(), plan)[name];
  const shown = (mm: number): string => shownNumber(Number(mm.toFixed(1)), language.value === "es");

  function stateOf(one: Item): State {
    const mark = marks.find(({ plan, name }) => keyOf(plan, name) === one.key);
    if (mark !== undefined) return kindOf(mark);
    if (one.isPole) return "printed";
    return guesses.has(one.key) ? "proposed" : leftOut.has(one.key) ? "out" : "none";
  }
  const isOpen = (one: Item): boolean => !one.isPole && !leftOut.has(one.key) && placeOf(one) === undefined;
  /** The first point behind this one without a place, else the first of all. */
  function next(after: string): string {
    const all = items();
    const from = all.findIndex(({ key }) => key === after) + 1;
    return [...all.slice(from), ...all.slice(0, from)].find(isOpen)?.key ?? "";
  }
  /** Whether the right plan is no secret: a student sees it when all points are marked or left out. */
  const mayShow = (): boolean => !app.student.value || (items().length > 0 && !items().some(isOpen) && marks.length > 0);

  function toggleRight(): void {
    if (!mayShow()) note = say("right_later");
    else wantsRight = shell.right.getAttribute("aria-pressed") !== "true";
    show();
  }

  function choose(key: string): void {
    chosen = key;
    leftOut.delete(key);
    note = "";
    show();
    // So that arrow keys move it.
    aim.focus({ preventScroll: true });
  }

  /** Puts the chosen point where the photograph has it. */
  function put(one: Item, tapped: Tapped): void {
    guesses.delete(one.key);
    bands.set(one.key, { at: String(tapped.at), band: tapped.band });
    form.change((file) => withTapped(file, one.plan, photo!, one.name, tapped), `photo ${one.key}`);
    form.left();
  }

  async function place(at: Pixel): Promise<void> {
    const one = item(chosen);
    if (one === undefined) {
      note = say("tap_none");
      return show();
    }
    const tapped = await ask(() => app.engine.photo_tap(one.plan.plan, at[0], at[1]));
    if (tapped === undefined) return;
    if (tapped === null) {
      note = say("outside");
      return show();
    }
    const isFirst = placeOf(one) === undefined;
    note = tapped.is_snapped ? "" : say("not_snapped");
    // Who corrects a point stays there; who goes through them goes on.
    if (isFirst) chosen = next(one.key);
    put(one, tapped);
  }

  function remove(one: Item): void {
    note = "";
    chosen = one.key;
    form.change((file) => withoutPoint(file, one.plan, one.name), `photo without ${one.key}`);
    form.left();
  }

  /** Asks the engine; where it was started anew, once more with the photograph. */
  async function ask<Answer>(question: () => Promise<Answer>): Promise<Answer | undefined> {
    try {
      return await question();
    } catch {
      try {
        if (picture === null) return undefined;
        await app.engine.photo(scene, original!.width, original!.height, greyOf(original!));
        return await question();
      } catch (error) {
        note = (error as { message?: string }).message ?? "";
        show();
        return undefined;
      }
    }
  }
  /** The photograph before it was turned upright. */
  let original: Photograph | null = null;

  const verdicts = newest<void>(async () => {
    const file = form.present();
    const placed = items().flatMap((one) => {
      const at = placesOn(file, one.plan)[one.name];
      if (at === undefined) return [];
      const own = bands.get(one.key);
      const band = at[2] ?? (own?.at === String([at[0], at[1]]) ? own.band : null);
      return [{ plan: one.plan.plan, name: one.name, at: [at[0], at[1]] as [number, number], band }];
    });
    const found = placed.length === 0 ? [] : ((await ask(() => app.engine.photo_points(placed))) ?? []);
    const labels = new Map(items().map(({ key, label }) => [key, label]));
    marks = found.map((verdict) => {
      const key = keyOf(verdict.plan, verdict.name);
      return { ...verdict, label: labels.get(key) ?? verdict.name, isChosen: key === chosen };
    });
    show();
  });

  const previews = newest<Pixel>(async (at) => {
    const one = item(chosen);
    const tapped = one === undefined ? null : await ask(() => app.engine.photo_tap(one.plan.plan, at[0], at[1]));
    if (aimedAt === null || photo === null) return;
    glass.show(aimedAt, tapped?.is_snapped ? (tapped.pixel as Pixel) : null, photo.per_mm);
  });
  let aimedAt: Pixel | null = null;

  const hands = touch(table, {
    pressed(key, isGuess) {
      const guess = guesses.get(key);
      const one = item(key);
      if (isGuess && guess !== undefined && one !== undefined) return accept([one]);
      if (!isGuess) choose(key);
    },
    aimed(at) {
      aimedAt = at;
      glass.show(at, null, photo?.per_mm ?? 1);
      if (at !== null && photo !== null) previews.want(at);
    },
    placed: (at) => void (photo !== null && place(at)),
  });

  function accept(all: Item[]): void {
    note = "";
    for (const one of all) {
      const guess = guesses.get(one.key);
      if (guess !== undefined) put(one, guess);
    }
    chosen = next(chosen);
    show();
  }

  aim.onkeydown = (event) => {
    const one = item(chosen);
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] as Pixel | undefined;
    if (photo === null || event.ctrlKey || event.metaKey) return;
    if (way !== undefined) {
      event.preventDefault();
      const step = event.shiftKey ? LARGE : STEP;
      const at = one === undefined ? undefined : placeOf(one);
      if (one === undefined || at === undefined) cursor = [cursor[0] + way[0] * step * photo.per_mm, cursor[1] - way[1] * step * photo.per_mm];
      else {
        const [x, y] = [at[0] + way[0] * step, at[1] + way[1] * step].map((mm) => Math.round(100 * mm) / 100) as Pixel;
        form.change((file) => withPoint(file, one.plan, photo!, one.name, [x, y], null), `photo move ${one.key}`);
        note = say("moved", { name: plain(one.label), x: shown(x), y: shown(y) });
      }
      show();
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      if (one !== undefined && placeOf(one) === undefined) void place(cursor);
      else choose(next(chosen));
    }
  };
  aim.onblur = () => form.left();
  root.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented) {
      if (!hands.cancel()) hide();
      event.preventDefault();
    }
    // What has keys here is no business of the picture below; undo is the page's.
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
  });

  function button(text: string, press: () => void, isMain = false): HTMLButtonElement {
    const made = element("button", { type: "button", class: isMain ? "main" : "" }, text);
    made.onclick = press;
    return made;
  }
  const another = (text: string, isMain: boolean): HTMLButtonElement => button(text, () => void askedFor("image/*").then((file) => void (file !== null && open(file))), isMain);

  /** Says what is to be done, how, and offers buttons for it; `html` is of the page's words and the engine's labels. */
  function say_(html: string, how: string, ...actions: HTMLElement[]): void {
    if (shell.prompt.innerHTML !== html) shell.prompt.innerHTML = html;
    if (shell.how.textContent !== how) shell.how.textContent = how;
    const key = actions.map((one) => one.textContent).join("\n");
    // The same buttons stay: one that is put in anew while it is pressed hears nothing.
    if (shell.actions.dataset["key"] === key && key !== "") return actions.forEach((one, index) => ((shell.actions.children[index] as HTMLButtonElement).onclick = one.onclick));
    shell.actions.dataset["key"] = key;
    shell.actions.replaceChildren(...actions);
  }

  function speak(): void {
    root.classList.toggle("refused", why !== null);
    if (busy !== null) return say_(say(busy), "");
    if (why !== null) {
      const told = document.createElement("span");
      told.textContent = why.message;
      return say_(told.innerHTML, why.hint, another(say("another"), true));
    }
    if (photo === null) return say_("", "", another(say("another"), true));
    const one = item(chosen);
    if (one === undefined) return finished();
    const name = one.label;
    const mark = marks.find(({ plan, name: own }) => keyOf(plan, own) === one.key);
    const onward = next(one.key);
    const forward = onward === "" ? button(say("see_check"), toResult, true) : button(say("next"), () => choose(onward), true);
    const guess = guesses.get(one.key);
    if (mark !== undefined) {
      const kind = kindOf(mark);
      const how = note !== "" ? note : kind === "open" ? say("open_how", { mm: shown(mark.off) }) : say("move_how");
      return say_(say(`is_${kind}`, { name, mm: shown(mark.off) }), how, button(say("take_away", { name: plain(name) }), () => remove(one)), forward);
    }
    if (one.isPole) return say_(say("at_printed", { name }), note !== "" ? note : say("move_how"), forward);
    const isBoth = (photo.plans.length ?? 0) > 1;
    const prompt = isBoth ? say("tap_in", { name, plan: say(planOf(one.plan)) }) : say("tap", { name });
    const skip = button(say("leave_out", { name: plain(name) }), () => {
      leftOut.add(one.key);
      choose(next(one.key));
    });
    const proposed = items().filter(({ key }) => guesses.has(key));
    if (guess !== undefined)
      return say_(prompt, note !== "" ? note : say("proposed_how"), skip, ...(proposed.length > 1 ? [button(say("accept_all", { count: proposed.length }), () => accept(proposed))] : []), button(say("accept", { name: plain(name) }), () => accept([one]), true));
    const isCoarse = window.matchMedia("(pointer: coarse)").matches;
    say_(prompt, note !== "" ? note : say(isCoarse ? "tap_how" : "tap_mouse"), skip);
  }

  function finished(): void {
    const count = (kind: string): number => marks.filter((mark) => kindOf(mark) === kind && item(keyOf(mark.plan, mark.name))?.isPole === false).length;
    const counts = say("all_counts", { right: count("right"), off: count("off"), open: count("open") });
    const file = form.present();
    const here = new Set(photo!.plans.map(planOf));
    const points = form.form()?.points;
    const missing = (["velocity", "acceleration"] as const).find((plan) => !here.has(plan) && (points?.[plan].length ?? 0) > 1 && file.points?.[plan] === undefined);
    const further = missing === undefined ? [] : [another(say("other_plan", { plan: say(missing) }), false)];
    say_(say("all_marked"), note !== "" ? note : counts, ...further, button(say("see_check"), toResult, true));
  }

  function toResult(): void {
    if (window.matchMedia(NARROW).matches) hide();
    form.toResult();
  }

  function show(): void {
    const all = items();
    const right = wantsRight && mayShow() && photo !== null ? photo.plans : [];
    shell.title.textContent = photo === null || why !== null ? say("title") : say("sheet_of", { name: photo.name, number: photo.number });
    shell.right.setAttribute("aria-pressed", String(right.length > 0));
    shell.right.classList.toggle("later", !mayShow());
    shell.right.hidden = shell.undo.hidden = photo === null || why !== null;
    bar.root.hidden = all.length === 0;
    bar.show(all.map((one): Entry => ({ key: one.key, plan: planOf(one.plan), label: one.label, state: stateOf(one) })), chosen);
    marks = marks.map((mark) => ({ ...mark, isChosen: keyOf(mark.plan, mark.name) === chosen }));
    const labels = new Map(all.map(({ key, label }) => [key, label]));
    table.over({ right, marks, guesses: [...guesses].map(([key, { pixel }]) => ({ key, label: labels.get(key) ?? "", pixel: pixel as Pixel })) });
    const one = item(chosen);
    aim.hidden = one === undefined;
    aim.setAttribute("aria-label", one === undefined ? "" : say("aim", { name: plain(one.label) }));
    root.setAttribute("aria-busy", String(busy !== null));
    moveAim();
    speak();
  }
  function moveAim(): void {
    const mark = marks.find((own) => own.isChosen);
    const [x, y] = table.view.toPane((mark?.pixel as Pixel | undefined) ?? cursor);
    aim.style.transform = `translate(${x}px, ${y}px)`;
  }
  table.view.now.on(moveAim);

  async function open(file: File): Promise<void> {
    [photo, why, busy, note, chosen, marks, guesses] = [null, null, "opening", "", "", [], new Map()];
    leftOut = new Set();
    table.show(null);
    reveal();
    show();
    const good = app.solved.value.good;
    original = picture = await photograph(file);
    if (picture === null) return refuse({ message: say("no_decode", { name: file.name }), hint: say("no_decode_hint") });
    if (good === "" || app.solved.value.refused !== null) return refuse({ message: say("no_scene"), hint: say("no_scene_hint") });
    busy = "reading";
    table.show(picture);
    show();
    const wanted = picture;
    try {
      const { width, height } = picture;
      const read = await app.engine.photo(good, width, height, greyOf(picture));
      if (picture !== wanted) return;
      const no = refusedBy(read);
      if (no !== null || read.photo === null) return refuse(no ?? { message: "", hint: "" });
      await take(read.photo, good);
    } catch (error) {
      const { message, hint } = error as { message: string; hint?: string | null };
      refuse({ message, hint: hint ?? "" });
    }
  }

  async function take(read: Photo, text: string): Promise<void> {
    [photo, scene, busy] = [read, text, null];
    picture = turned(picture!, read.turn);
    table.show(picture);
    const box = boxOf(read.plans, picture, read.per_mm);
    table.view.fit(box);
    cursor = [box[0] + box[2] / 2, box[1] + box[3] / 2];
    isThere.set(true);
    chosen = next("");
    if (read.bend > 3) note = say("bent", { mm: shown(read.bend) });
    show();
    verdicts.want();
    aim.focus({ preventScroll: true });
    // Found while the eye looks, so that the first tap waits for nothing.
    await ask(() => app.engine.photo_lines());
  }

  /** Another scene, or the same in other words: the photograph is read anew, and goes where it is not of it. */
  async function again(text: string): Promise<void> {
    scene = text;
    const read = original === null ? null : await app.engine.photo(text, original.width, original.height, greyOf(original)).catch(() => null);
    if (text !== scene) return;
    if (read !== null && read.photo !== null && refusedBy(read) === null) {
      photo = read.photo;
      return verdicts.want();
    }
    [photo, picture, original] = [null, null, null];
    table.show(null);
    isThere.set(false);
    hide();
  }

  function refuse(no: Why): void {
    [photo, why, busy] = [null, no, null];
    isThere.set(false);
    show();
    shell.actions.querySelector("button")?.focus();
  }

  /** What the photograph covers rests. */
  function rest(): void {
    const isNarrow = window.matchMedia(NARROW).matches;
    const covered = [...byId("main").children].filter((one) => one !== root);
    for (const one of [...covered, byId("toolbar"), byId("side")] as HTMLElement[]) {
      const isBeside = one.id === "toolbar" || one.id === "side" || one.classList.contains("bar");
      one.inert = isShown.value && (!isBeside || isNarrow);
    }
  }
  window.matchMedia(NARROW).addEventListener("change", rest);

  function reveal(): void {
    if (isShown.value) return;
    opener = document.activeElement;
    root.hidden = false;
    document.body.classList.add("photographing");
    isShown.set(true);
    rest();
    if (photo !== null) show();
  }

  function hide(): void {
    if (!isShown.value) return;
    root.hidden = true;
    document.body.classList.remove("photographing");
    isShown.set(false);
    rest();
    if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
    if (why !== null) why = null;
  }

  app.shown.on((panel) => panel !== "check" && hide());
  app.solved.on(({ good, refused }) => void (photo !== null && refused === null && good !== scene && again(good)));
  app.student.on(() => isShown.value && show());
  language.on(() => isShown.value && show());

  return {
    isShown,
    isThere,
    open,
    show: reveal,
    hide,
    follow: () => void (photo !== null && verdicts.want()),
  };
}
