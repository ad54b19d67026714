import type { App } from "../../../app.ts";
import { goOnWith } from "../../../board/begun.ts";
import { element } from "../../../dom/element.ts";
import { byId } from "../../../dom/find.ts";
import type { Photo, Refused, Tapped } from "../../../engine/types.ts";
import { askedFor } from "../../../files/open.ts";
import { undo } from "../../../layout/keys.ts";
import { newest } from "../../../state/newest.ts";
import { signal, type Signal } from "../../../state/signal.ts";
import { goodText } from "../../../state/solving.ts";
import { language } from "../../../words.ts";
import { aiming } from "./aiming.ts";
import { frame } from "./frame.ts";
import { loupe } from "./loupe.ts";
import { type Photograph, photograph, turned } from "./picture.ts";
import { keyOf, placesOn } from "./placing.ts";
import { plain, pointsBar } from "./points_bar.ts";
import { button, millimetres, type Prompt, prompt } from "./prompt.ts";
import { refusedBy, type Why } from "./refusals.ts";
import { type FormOf, type Item, sent, type Session, session } from "./session.ts";
import { boxOf, type Pixel, stage } from "./stage.ts";
import { touch } from "./touch.ts";
import { say } from "./words.ts";

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

/** Narrower than this the photograph fills the screen, as panels stand below the picture. */
const NARROW = "(max-width: 959.9px)";
/** Under a finger a crossing may be so far away, in pixels of the screen; and most and least, in mm. */
const FINGER = 16;
const [NEAR, FAR] = [1.5, 6];
/** Crossings that are nearer to a mark than this, in mm, are its own; a tap is on a mark that is nearer than the next, in pixels of the screen. */
const [SAME, ON] = [0.5, 5];
/** Nobody aims better than this, in mm; nor, with a finger that sees the place magnified, than the next. */
const [LEAST_AIM, MAGNIFIED] = [0.3, 0.6];
/** A point that seems to be nearer than this to its right place, in mm, stands at the same letter. */
const BESIDE = 3;
/** A sheet that is bent by more, in mm, is worth a word. */
const BENT = 3;

/** A photograph of the student's drawing in place of the picture: the right plan over it, points that are tapped go into the form. */
export function photoView(app: App, form: FormOf): PhotoView {
  const isShown = signal(false);
  const isThere = signal(false);
  let picture: Photograph | null = null;
  /** As the engine got it, before it was turned upright. */
  let original: Photograph | null = null;
  let own: Session | null = null;
  let why: Why | null = null;
  let busy: "opening" | "reading" | null = null;
  let wantsRight = true;
  /** What was last to be told, as long as the form stays as it was then. */
  let noted = { text: "", form: "" };
  let opener: Element | null = null;

  const table = stage();
  const glass = loupe(table);
  const aim = aiming(table, () => own, { place: (at) => void place(at, 0), next: () => own !== null && choose(own.next(own.chosen)), moved, left: form.left });
  table.root.append(aim.root, glass.root);
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
  const acts = { choose, accept, leaveOut, remove, toResult, toBoard, another: () => void askedFor("image/*").then((file) => void (file !== null && open(file))) };
  const isNarrow = (): boolean => window.matchMedia(NARROW).matches;
  /** How far a tap reaches for a crossing, in mm. */
  const reach = (): number => Math.min(FAR, Math.max(NEAR, FINGER / (table.view.now.value.scale * (own?.photo.per_mm ?? 1))));

  /** Within how many mm a hand meets a place, in pixels of the screen or, under the magnifier, of that. */
  const aimFor = (within: number): number => Math.max(LEAST_AIM, within === 0 ? MAGNIFIED : within / (table.view.now.value.scale * (own?.photo.per_mm ?? 1)));

  const note = (text: string): void => void (noted = { text, form: app.history.now.value.form });

  /** Whether the right plan is no secret: a student sees it when all points are marked or left out. */
  const mayShow = (): boolean => !app.student.value || (own !== null && own.marks.length > 0 && !own.items.some(own.isOpen));

  function toggleRight(): void {
    if (!mayShow()) note(say("right_later"));
    else wantsRight = shell.right.getAttribute("aria-pressed") !== "true";
    show();
  }

  function choose(key: string): void {
    if (own === null) return;
    own.chosen = key;
    const one = own.item(key);
    if (one !== undefined) own.leaveOut(one, false);
    note("");
    lookAt(one);
    show();
    aim.root.focus({ preventScroll: true });
  }

  /** On a small screen the plan of the point fills it, unless somebody has zoomed; without a point all plans. */
  function lookAt(one: Item | undefined): void {
    if (picture === null || own === null || table.view.alone() === null) return;
    table.view.fit(boxOf(isNarrow() && one !== undefined ? [one.plan] : own.photo.plans, picture, own.photo.per_mm));
  }

  function go(after: string): void {
    if (own === null) return;
    own.chosen = own.next(after);
    lookAt(own.item(own.chosen));
  }

  /** The place that somebody means who taps there: not that of another point which is marked already, unless the tap is on it. */
  async function meant(of: Session, one: Item, at: Pixel, within: number): Promise<Tapped | null | undefined> {
    const tapped = await of.tap(one, at, reach(), aimFor(within));
    const apart = (a: number[], b: number[]): number => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!);
    const other = tapped?.is_snapped === true && of.marks.find((mark) => keyOf(mark.plan, mark.name) !== one.key && apart(mark.pixel, tapped.pixel) < SAME * of.photo.per_mm);
    if (!other || apart(other.pixel, at) * table.view.now.value.scale < ON) return tapped;
    return of.tap(one, at, (0.6 * apart(other.pixel, at)) / of.photo.per_mm, aimFor(within));
  }

  async function place(at: Pixel, within: number): Promise<void> {
    const one = own?.item(own.chosen);
    if (own === null || one === undefined) {
      note(say("tap_none"));
      return show();
    }
    const tapped = await meant(own, one, at, within);
    if (tapped === undefined) return;
    if (tapped === null) {
      note(say("outside"));
      return show();
    }
    // Who corrects a point stays there; who goes through them goes on.
    const isFirst = own.placeOf(one) === undefined;
    own.put([[one, tapped]]);
    note(tapped.is_snapped ? "" : say("not_snapped", { mm: millimetres(tapped.band) }));
    if (isFirst && !one.isPole) go(one.key);
    show();
  }

  function accept(all: Item[]): void {
    if (own === null) return;
    note("");
    const { guessOf } = own;
    own.put(all.flatMap((one): [Item, Tapped][] => {
      const guess = guessOf(one);
      return guess === undefined ? [] : [[one, guess]];
    }));
    go(own.chosen);
    show();
  }

  function leaveOut(one: Item): void {
    own?.leaveOut(one, true);
    note("");
    go(one.key);
    show();
  }

  function remove(one: Item): void {
    note("");
    own?.remove(one);
    show();
  }

  function moved(one: Item, at: Pixel): void {
    own?.move(one, at);
    note(say("moved", { name: plain(one.label), x: millimetres(at[0]), y: millimetres(at[1]), origin: plain(one.plan.points[0]?.label ?? "") }));
    show();
  }

  const verdicts = newest<void>(async () => {
    await own?.judge();
    show();
  });

  let aimedAt: Pixel | null = null;
  const previews = newest<Pixel>(async (at) => {
    const one = own?.item(own.chosen);
    const tapped = own === null || one === undefined ? null : await meant(own, one, at, 0);
    if (aimedAt !== null && own !== null) glass.show(aimedAt, tapped?.is_snapped ? (tapped.pixel as Pixel) : null, own.photo.per_mm);
  });
  const hands = touch(table, {
    held: choose,
    guessed(key) {
      const one = own?.item(key);
      // Who is to mark another point may mean that one.
      if (one !== undefined && key === own?.chosen) accept([one]);
      else choose(key);
    },
    aimed(at) {
      aimedAt = own === null ? null : at;
      glass.show(aimedAt, null, own?.photo.per_mm ?? 1);
      if (aimedAt !== null) previews.want(aimedAt);
    },
    isAsked: () => own !== null && own.chosen !== "" && own.item(own.chosen)?.isPole === false && own.isOpen(own.item(own.chosen)!),
    placed: (at, within) => void (own !== null && place(at, within)),
  });

  root.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented) {
      if (!hands.cancel()) hide();
      event.preventDefault();
    }
    // What has keys here is no business of the picture below; undo is the page's.
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
  });

  /** What is said, with its buttons. */
  function said(): Prompt {
    if (busy !== null) return { html: say(busy), how: "", actions: [] };
    if (why === null && own !== null) return prompt(own, form, acts, noted.form === app.history.now.value.form ? noted.text : "");
    const told = element("span", {}, why?.message ?? "");
    return { html: told.innerHTML, how: why?.hint ?? "", actions: [button(say("another"), acts.another, true)] };
  }

  function speak(): void {
    const { html, how, actions } = said();
    root.classList.toggle("refused", why !== null && busy === null);
    // What is the same is not said twice.
    if (shell.prompt.dataset["html"] !== html) shell.prompt.innerHTML = html;
    shell.prompt.dataset["html"] = html;
    if (shell.how.textContent !== how) shell.how.textContent = how;
    // The keys stay where they are when buttons become others.
    const hadKeys = shell.actions.contains(document.activeElement);
    shell.actions.replaceChildren(...actions);
    if (hadKeys) (shell.actions.querySelector<HTMLElement>(".main") ?? aim.root).focus({ preventScroll: true });
  }

  function show(): void {
    const photo = own?.photo ?? null;
    const items = own?.items ?? [];
    const right = wantsRight && mayShow() && photo !== null ? photo.plans : [];
    shell.title.textContent = photo === null ? say("title") : say("sheet_of", { name: photo.name, number: photo.number });
    shell.right.setAttribute("aria-pressed", String(right.length > 0));
    shell.right.classList.toggle("later", !mayShow());
    shell.right.hidden = shell.undo.hidden = photo === null;
    bar.root.hidden = items.length === 0;
    bar.show(items.map((one) => ({ key: one.key, plan: one.plan.plan, label: one.label, state: own!.stateOf(one) })), own?.chosen ?? "");
    const marks = (own?.marks ?? []).map((mark) => ({ ...mark, isChosen: keyOf(mark.plan, mark.name) === own?.chosen }));
    const guesses = items.flatMap((one) => {
      const pixel = own?.guessOf(one)?.pixel as Pixel | undefined;
      const at = one.plan.points.find(({ name }) => name === one.name)?.at ?? [0, 0];
      if (pixel === undefined || photo === null) return [];
      const isNear = Math.hypot(pixel[0] - at[0], pixel[1] - at[1]) < BESIDE * photo.per_mm && right.length > 0;
      return [{ key: one.key, label: one.label, pixel, isNear, isChosen: one.key === own?.chosen }];
    });
    table.over({ right, marks, guesses });
    root.setAttribute("aria-busy", String(busy !== null));
    aim.show();
    speak();
  }

  async function open(file: File): Promise<void> {
    [own, why, busy] = [null, null, "opening"];
    note("");
    isThere.set(false);
    table.show(null);
    reveal();
    show();
    const taken = await photograph(file);
    original = picture = taken;
    const good = await goodText(app).catch(() => "");
    const { refused } = app.solved.value;
    if (taken === null) return refuse({ message: say("no_decode", { name: file.name }), hint: say("no_decode_hint") });
    if (good === "" || refused !== null) return refuse({ message: say("no_scene"), hint: say("no_scene_hint") });
    busy = "reading";
    table.show(taken);
    show();
    try {
      const read = await sent(app, form, taken, good);
      if (original !== taken) return;
      const no = refusedBy(read);
      if (no !== null || read.photo === null) return refuse(no ?? { message: "", hint: "" });
      await take(taken, read.photo, good);
    } catch (error) {
      const { message, hint } = error as Refused;
      refuse({ message, hint: hint ?? "" });
    }
  }

  async function take(taken: Photograph, read: Photo, text: string): Promise<void> {
    const begun = session(app, form, taken, read, text);
    own = begun;
    busy = null;
    picture = turned(taken, read.turn);
    table.show(picture);
    lookAt(begun.item(begun.chosen) ?? begun.items[0]);
    aim.middle();
    isThere.set(true);
    if (read.warning) note(read.warning);
    else if (read.bend > BENT) note(say("bent", { mm: millimetres(read.bend) }));
    show();
    aim.root.focus({ preventScroll: true });
    // While the eye looks, so that the first tap waits for nothing.
    await begun.look();
    if (own === begun) verdicts.want();
  }

  /** Another scene, or the same in other words: the photograph is read anew, and goes where it is not of it. */
  async function again(text: string): Promise<void> {
    if (own === null || original === null) return;
    own.scene = text;
    const read = await sent(app, form, original, text).catch(() => null);
    if (own === null || own.scene !== text) return;
    if (read !== null && read.photo !== null && refusedBy(read) === null) {
      own.renew(read.photo, text);
      await own.look();
      return verdicts.want();
    }
    [own, picture, original] = [null, null, null];
    table.show(null);
    isThere.set(false);
    hide();
  }

  function refuse(no: Why): void {
    [own, why, busy] = [null, no, null];
    show();
    shell.actions.querySelector("button")?.focus();
  }

  /** What the photograph covers rests. */
  function rest(): void {
    const covered = [...byId("main").children].filter((one) => one !== root);
    for (const one of [...covered, byId("toolbar"), byId("side")] as HTMLElement[]) {
      const isBeside = one.id === "toolbar" || one.id === "side" || one.classList.contains("bar");
      one.inert = isShown.value && (!isBeside || isNarrow());
    }
  }
  window.matchMedia(NARROW).addEventListener("change", rest);

  function reveal(): void {
    if (isShown.value) return;
    opener = document.activeElement;
    root.hidden = false;
    isShown.set(true);
    rest();
    if (own !== null) show();
  }

  function hide(): void {
    if (!isShown.value) return;
    root.hidden = true;
    isShown.set(false);
    rest();
    if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
  }

  function toResult(): void {
    if (isNarrow()) hide();
    form.toResult();
  }

  function toBoard(): void {
    if (own === null) return;
    const file = form.present();
    const plans = own.photo.plans.map((plan) => {
      const points = Object.entries(placesOn(file, plan)).filter(([name]) => name !== plan.points[0]?.name);
      return { sheet: plan.plan, mu: plan.mu, points: points.map(([name, [x, y]]): [string, number, number] => [name, x, y]) };
    });
    void goOnWith(app, plans);
  }

  app.shown.on((panel) => panel !== "check" && hide());
  app.solved.on(({ good, refused }) => void (own !== null && refused === null && good !== own.scene && again(good)));
  app.student.on(() => isShown.value && show());
  language.on(() => isShown.value && show());

  return { isShown, isThere, open, show: reveal, hide, follow: () => void (own !== null && verdicts.want()) };
}
