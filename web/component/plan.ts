/** The element `<kinegon-plan>`: a scene with its steps and its motion, made of the parts of the workbench. */
import style from "kinegon-style.css";
import tree from "kinegon-tree.txt";
import type { Shown, Solved } from "../page/app.ts";
import { byId } from "../page/dom/find.ts";
import type { Checked, Picture, Pins, Refused, SceneFile, Step, Value, View } from "../page/engine/types.ts";
import { loadFonts } from "../page/fonts.ts";
import { sayAll } from "../page/layout/say.ts";
import { say } from "../page/layout/words.ts";
import { drives, type Drives } from "../page/motion/drives.ts";
import { play, type Play } from "../page/motion/play.ts";
import { bubble } from "../page/picture/bubble.ts";
import { described } from "../page/picture/described.ts";
import { gestures } from "../page/picture/gesture.ts";
import { handles } from "../page/picture/handles.ts";
import { pane } from "../page/picture/pane.ts";
import { currentPicture } from "../page/picture/picture.ts";
import { pulling } from "../page/picture/pulling.ts";
import { paneOf } from "../page/picture/surface.ts";
import { viewport, type Viewport } from "../page/look/viewport.ts";
import { said, withLine } from "../page/refused.ts";
import { history } from "../page/state/history.ts";
import { owned, signal, type Signal } from "../page/state/signal.ts";
import { solving } from "../page/state/solving.ts";
import { stepsBar } from "../page/steps/bar.ts";
import { steps, type Steps } from "../page/steps/steps.ts";
import { language, usual } from "../page/words.ts";
import { engineFor } from "./engine.ts";
import { isOnDark, watchGround } from "./ground.ts";
import { sceneText } from "./source.ts";

/** White around the sheet, in pixels: nothing stands above it. */
const MARGIN = 6;
/** How far outside the window a plan begins to be made, in pixels; and how long a word stays, in ms. */
const [AHEAD, STAYS] = [400, 5000];

/** All that there is once the plan is shown. */
interface Parts {
  app: Shown;
  steps: Steps;
  play: Play;
  end(): void;
}

/** Keys with which controls are used. */
const KEYS = /^(Arrow.*|Page.*|Home|End|Enter| )$/;

let letters: Promise<void> | undefined;

const sheet = new CSSStyleSheet();
sheet.replaceSync(style);

export class KinegonPlan extends HTMLElement {
  static readonly observedAttributes = ["src", "step", "controls", "theme"];

  readonly #root = this.attachShadow({ mode: "open" });
  #parts: Parts | null = null;
  #text: string | null = null;
  #dark = signal(false);
  #watch: IntersectionObserver | null = null;
  /** Counts what is shown: what is still awaited for an earlier scene is wanted no more. */
  #turn = 0;
  #whenReady!: () => void;
  /** Settles when the first picture stands, or the scene is refused. */
  readonly ready = new Promise<void>((done) => (this.#whenReady = done));

  constructor() {
    super();
    this.#root.adoptedStyleSheets = [sheet];
    this.#root.innerHTML = tree;
    // What a control does with a key, slides and books need not do, too.
    this.#root.addEventListener("keydown", (event) => KEYS.test((event as KeyboardEvent).key) && event.stopPropagation());
  }

  connectedCallback(): void {
    language.set(usual(document.documentElement.lang || null));
    // Whoever moves it within the page gets it as it stood.
    if (this.#isWired) this.#root.innerHTML = tree;
    this.#isWired = false;
    this.#controls();
    watchGround(this, this.#ground);
    this.#ground();
    // Far below the window nothing is solved.
    this.#watch = new IntersectionObserver((seen) => seen.some(({ isIntersecting }) => isIntersecting) && void this.#begin(), { rootMargin: `${AHEAD}px` });
    this.#watch.observe(this);
  }

  disconnectedCallback(): void {
    this.#turn += 1;
    watchGround(this, null);
    this.#watch?.disconnect();
    this.#text = this.#parts?.app.history.now.value.text ?? this.#text;
    this.#parts?.end();
    this.#parts = null;
    this.#hasBegun = this.#isReady = false;
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (before === now || !this.isConnected) return;
    if (name === "theme") this.#ground();
    else if (name === "controls") this.#controls();
    else if (name === "step") this.#goTo(this.#asked());
    else if (this.#hasBegun) {
      this.#text = null;
      void this.#read();
    }
  }

  /** The scene as it stands, as its file has it; null before there is one. */
  get scene(): SceneFile | null {
    return this.#parts?.app.solved.value.opened?.scene ?? null;
  }
  set scene(scene: SceneFile | string) {
    this.#text = typeof scene === "string" ? scene : JSON.stringify(scene, null, 2);
    if (this.#parts !== null) this.#parts.app.history.change({ text: this.#text });
    else void this.#begin();
  }

  /** The step after which it is shown, from 1; null for the finished plans. */
  get step(): number | null {
    return this.#parts?.app.view.value.step ?? null;
  }
  set step(step: number | null) {
    if (step === null) this.removeAttribute("step");
    else this.setAttribute("step", String(step));
    this.#goTo(step);
  }

  /** The steps of the construction. */
  get steps(): readonly Step[] {
    return this.#parts?.app.solved.value.opened?.steps ?? [];
  }

  get playing(): boolean {
    return this.#parts?.play.on.value ?? false;
  }

  next(): void {
    this.#parts?.steps.by(1);
  }

  back(): void {
    this.#parts?.steps.by(-1);
  }

  play(): void {
    if (!this.playing) this.#parts?.play.toggle();
  }

  pause(): void {
    this.#parts?.play.stop();
  }

  /** All rates, velocities and accelerations with those digits that are certain. */
  async values(): Promise<Value[]> {
    const { app } = await this.#there();
    return app.engine.values(app.history.now.value.text);
  }

  /** The verdict on measured values: by their names, or a form file of `kinegon check` as an object or a text. */
  async check(form: string | Record<string, unknown>): Promise<Checked> {
    const { app } = await this.#there();
    const whole = typeof form === "string" || "kinegon_measured" in form ? form : { kinegon_measured: 1, values: form };
    const text = typeof whole === "string" ? whole : JSON.stringify(whole);
    return app.engine.check(app.history.now.value.text, text, { marks: null, pencil_mm: null, pencil_degrees: null, drawn: false });
  }

  async #there(): Promise<Parts> {
    if (this.#parts === null) await this.#begin();
    if (this.#parts === null) throw new Error("the plan has no scene, or is not in the page");
    return this.#parts;
  }

  #hasBegun = false;
  #begun: Promise<void> | null = null;

  #begin(): Promise<void> {
    this.#watch?.disconnect();
    this.#hasBegun = true;
    return (this.#begun ??= this.#read().finally(() => (this.#begun = null)));
  }

  /** Reads the scene, wherever it stands, and shows it. */
  async #read(): Promise<void> {
    const turn = (this.#turn += 1);
    try {
      const text = this.#text ?? (await sceneText(this));
      if (turn !== this.#turn) return;
      if (this.#parts !== null) return this.#parts.app.history.change({ text });
      const engine = await engineFor((why) => say(why, { seconds: 20 }));
      if (turn !== this.#turn || !this.isConnected) return void engine.free();
      letters ??= loadFonts(engine).catch(() => undefined);
      this.#parts = this.#made(text, engine);
    } catch (why) {
      if (turn === this.#turn) this.#refuse(why as Refused | Error);
    }
  }

  #made(text: string, engine: Awaited<ReturnType<typeof engineFor>>): Parts {
    const step = this.#asked();
    const app: Shown = {
      root: this.#root,
      history: history({ text, form: "" }),
      engine,
      solved: signal<Solved>({ text: "", opened: null, good: "", refused: null }),
      typing: signal(false),
      view: signal<View>({ step, coarse: false, modes: false }),
      paper: signal(false),
      picture: signal<Picture | null>(null),
      dark: this.#dark,
      shaping: signal(false),
      pins: signal<Pins>({ points: [], lengths: [] }),
      building: signal(false),
      student: signal(false),
      tell: (message) => this.#tell(message),
      speak: (message) => this.#tell(message, true),
    };
    const { made, end } = owned(() => this.#wired(app));
    return { app, ...made, end: () => (made.play.stop(), end(), void engine.free()) };
  }

  #wired(app: Shown): Pick<Parts, "steps" | "play"> {
    sayAll(this.#root);
    this.#isWired = true;
    this.#controls();
    byId("pane", this.#root).hidden = false;
    const view = viewport(MARGIN);
    const sight = surfaceOf(app, view);
    pane(app, view);
    const current = currentPicture(app, sight, () => hands.isActive());
    const hands = gestures(app, sight, (picture) => app.picture.set(picture), current);
    const going = steps(app);
    handles(app, view, pulling(app, view, hands, bubble(app)));
    described(app);
    const parts: { drives?: Drives; play?: Play } = {};
    parts.drives = drives(app, hands, () => parts.play?.stop());
    const running = (parts.play = play(app, hands, () => parts.drives!));
    stepsBar(app, going);
    app.picture.on((picture) => {
      if (picture === null) return;
      view.fit([0, 0, picture.width, picture.height]);
      this.#first();
    });
    app.solved.on(({ opened, refused }) => {
      if (refused !== null) this.#refuse(refused);
      else if (opened !== null) this.#good(opened.title);
    });
    this.#steps(app, going);
    let played = false;
    running.on.on((playing) => playing !== played && ((played = playing), this.#send("kinegon-play", { playing })));
    let shown = app.history.now.value;
    app.history.now.on((now) => now !== shown && ((shown = now), this.#send("kinegon-change", { text: now.text })));
    solving(app);
    return { steps: going, play: running };
  }

  /** Tells of each step once. */
  #steps(app: Shown, going: Steps): void {
    let before = app.view.value.step;
    app.view.on(({ step }) => {
      if (step === before) return;
      before = step;
      this.#send("kinegon-step", { step, count: going.count(), caption: going.said()?.caption ?? "" });
    });
  }

  /** The step that the attribute asks for. */
  #asked(): number | null {
    const number = Number.parseInt(this.getAttribute("step") ?? "", 10);
    return Number.isFinite(number) && number >= 1 ? number : null;
  }

  #goTo(step: number | null): void {
    if (this.#parts === null) return;
    if (step === null) this.#parts.app.view.set({ ...this.#parts.app.view.value, step: null });
    else this.#parts.steps.go(step);
  }

  #isWired = false;

  #controls(): void {
    const has = this.hasAttribute("controls");
    const find = (id: string): HTMLElement => byId(id, this.#root);
    find("motion").hidden = !has || !this.#isWired;
    find("handles").hidden = !has;
    find("component").classList.toggle("bare", !has);
  }

  #ground = (): void => {
    const theme = this.getAttribute("theme");
    const is = theme === "dark" || (theme !== "light" && isOnDark(this));
    byId("component", this.#root).dataset["theme"] = is ? "dark" : "light";
    this.#dark.set(is);
  };

  #isReady = false;

  /** The first picture stands: what stood in its place goes. */
  #first(): void {
    if (this.#isReady) return;
    this.#isReady = true;
    this.#root.querySelector("slot")!.hidden = true;
    this.#whenReady();
    this.#send("kinegon-ready", { title: this.#parts?.app.solved.value.opened?.title ?? "", steps: this.steps.length });
  }

  #good(title: string): void {
    byId("message", this.#root).hidden = true;
    byId("component", this.#root).setAttribute("aria-label", title);
  }

  /** One message; of what the element holds, or of the last good picture, nothing goes. */
  #refuse(why: Refused | Error): void {
    const place = byId("message", this.#root);
    const line = "line" in why ? why.line : null;
    const message = "line" in why ? [withLine(why), why.hint].filter(Boolean).join(" ") : said(why);
    place.textContent = message;
    place.hidden = false;
    byId("pane", this.#root).hidden = this.#parts?.app.picture.value == null;
    this.#whenReady();
    this.#send("kinegon-error", { message, line });
  }

  #clock = 0;

  #tell(message: string, isAloud = false): void {
    const place = byId("said", this.#root);
    clearTimeout(this.#clock);
    place.textContent = message;
    place.classList.toggle("shown", !isAloud);
    this.#clock = window.setTimeout(() => place.classList.remove("shown"), STAYS);
  }

  #send(name: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }
}

/** The view on the part of the screen that the plan has. */
function surfaceOf(app: Shown, view: Viewport): Signal<View> {
  const sight = signal<View>(app.view.value);
  const look = (): void => {
    const { width, height } = view.room();
    if (width < 1 || height < 1) return;
    const pane = paneOf(width, height);
    byId("component", app.root).classList.toggle("worded", pane.words);
    sight.set({ ...app.view.value, pane });
  };
  app.view.on(look);
  view.resized.on(look);
  return sight;
}

if (!customElements.get("kinegon-plan")) customElements.define("kinegon-plan", KinegonPlan);
