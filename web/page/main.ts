/** Wires the page: store → engine → picture → panels. */
import type { App, Solved } from "./app.ts";
import { board } from "./board/board.ts";
import { build } from "./build/build.ts";
import { byId } from "./dom/find.ts";
import { startEngine, type EngineClient } from "./engine/client.ts";
import { PATIENCE, type Why } from "./engine/hand.ts";
import type { Picture, View } from "./engine/types.ts";
import { loadFonts } from "./fonts.ts";
import type { HandedIn } from "./board/class.ts";
import { dropped } from "./layout/brought.ts";
import { documents } from "./layout/documents.ts";
import { fullScreen } from "./layout/full.ts";
import { help } from "./layout/help.ts";
import { keys } from "./layout/keys.ts";
import { courseNotices, messages, notice, speak, teller } from "./layout/messages.ts";
import { printedByBrowser, printer } from "./layout/print.ts";
import { sayAll } from "./layout/say.ts";
import { splitter } from "./layout/splitter.ts";
import { tabs } from "./layout/tabs.ts";
import { isDark, theme } from "./layout/theme.ts";
import { tour } from "./layout/tour.ts";
import { toolbar } from "./layout/toolbar.ts";
import { say } from "./layout/words.ts";
import { working } from "./layout/working.ts";
import { drives, type Drives } from "./motion/drives.ts";
import { filming } from "./motion/film.ts";
import { play, type Play } from "./motion/play.ts";
import { PANELS } from "./panels/all.ts";
import { bubble } from "./picture/bubble.ts";
import { clicked } from "./picture/clicked.ts";
import { described } from "./picture/described.ts";
import { meaning } from "./picture/meaning.ts";
import { focus } from "./picture/focus.ts";
import { frames, gestures } from "./picture/gesture.ts";
import { handles } from "./picture/handles.ts";
import { looking } from "./picture/looking.ts";
import { pane } from "./picture/pane.ts";
import { currentPicture } from "./picture/picture.ts";
import { pulling } from "./picture/pulling.ts";
import { surface } from "./picture/surface.ts";
import { viewport } from "./look/viewport.ts";
import type { Sheet } from "./sheets.ts";
import { baseOf, documentOf, hashOf, type BadLink, type BoardUse, type Shared, type Task } from "./state/address.ts";
import { asKept, autosave } from "./state/autosave.ts";
import { course } from "./state/course.ts";
import { examOf } from "./state/exam.ts";
import { history, type Document } from "./state/history.ts";
import { beginning, type Beginning } from "./state/route.ts";
import { signal } from "./state/signal.ts";
import { solving } from "./state/solving.ts";
import { store as browserStore, type Kept, type Store } from "./state/storage.ts";
import { STUDENTS_PANEL, studying } from "./state/studying.ts";
import { stepsBar } from "./steps/bar.ts";
import { steps } from "./steps/steps.ts";
import { language, usual } from "./words.ts";

const FINISHED: View = { step: null, coarse: false, modes: false };

/** The first document, where nothing else gives one: a mechanism whose crank turns right round. */
async function firstKind(engine: EngineClient): Promise<Shared> {
  const kinds = await engine.kinds();
  return { text: (kinds.find((kind) => kind.name === "watt-1") ?? kinds[0])?.text ?? "" };
}

function application(shared: Shared & Partial<Kept>, past: Document[], engine: EngineClient, tell: App["tell"]): App {
  const asked = shared.asked ?? { text: shared.text, form: shared.form ?? "" };
  const hears = course(asked.form);
  // What this very tab has is newer than what the course has kept.
  const form = shared.asked === undefined && hears !== null ? hears.form : (shared.form ?? "");
  const drawing = shared.asked === undefined && hears !== null && hears.drawing !== "" ? hears.drawing : (shared.drawing ?? "");
  const own = {
    history: history({ text: shared.text, form, drawing }, past),
    student: signal(shared.student ?? false),
    board: signal<BoardUse | null>(shared.board ?? null),
  };
  const app: App = {
    root: document,
    ...own,
    exam: examOf(own),
    engine,
    solved: signal<Solved>({ text: "", opened: null, good: "", refused: null }),
    typing: signal(false),
    view: signal<View>(shared.view ?? FINISHED),
    paper: signal(false),
    focus: signal<Sheet | "">(""),
    traced: signal<string[]>([]),
    picture: signal<Picture | null>(null),
    dark: isDark,
    shaping: signal(false),
    pins: signal({ points: [], lengths: [] }),
    building: signal(false),
    card: signal<App["card"]["value"]>(null),
    task: signal<Task | null>(shared.task ?? null),
    drawing: signal(false),
    course: hears,
    asked,
    tell,
    speak,
    shown: signal(""),
    // A student has one panel; the others show answers.
    show: (panel) => (!app.student.value || panel === "" || panel === STUDENTS_PANEL) && app.shown.set(panel),
    place: signal<{ from: number; to: number } | null>(null),
    brought: signal<{ name: string; text: string } | null>(null),
    handed: signal<readonly HandedIn[]>([]),
    photographed: signal<File | null>(null),
    film: null,
    open(text) {
      if (app.exam.value) return tell(say("exam_open"));
      app.task.set(null);
      app.board.set(null);
      app.history.change({ text, drawing: "" });
    },
    link: async (what) => baseOf(location.href) + (await hashOf(what)),
    print: printer(),
  };
  hears?.follow(() => app.history.now.value);
  return app;
}

/** Picture, joints, gestures, motion, steps. */
function wire(app: App, store: Store): void {
  const view = viewport();
  const parts: { drives?: Drives; play?: Play } = {};
  const full = fullScreen();
  pane(app, view);
  const sight = surface(app, view, full.on);
  const current = currentPicture(app, sight, () => hands.isActive());
  const hands = gestures(app, sight, (picture) => app.picture.set(picture), current);
  const going = steps(app);
  const own = focus(app, view);
  handles(app, view, pulling(app, view, hands, bubble(app)));
  looking(app, view, own);
  clicked(app, view);
  described(app);
  meaning(app);
  parts.drives = drives(app, hands, () => parts.play?.stop());
  parts.play = play(app, hands, () => parts.drives!);
  app.film = filming(app, hands, parts.drives);
  stepsBar(app, going);
  toolbar(app, store);
  messages(app);
  build(app);
  board(app);
  documents(app, store);
  dropped(app);
  printedByBrowser(app);
  keys(app, { steps: going, drives: parts.drives, play: parts.play, full, store });
}

/** Why a link was not read. */
function badLink(why: BadLink): string {
  return say(({ broken: "link_broken", newer: "link_newer", too_large: "link_too_large" } as const)[why]);
}

/** A link that comes while the page is open, and the ways back from it and to it; and the address is cleaned, so that it never says something old. */
function watchAddress(app: App, store: Store): void {
  const clean = (link: string): void => window.history.replaceState(link, "", location.href.replace(/#.*/s, ""));
  // The link of the tab's entry, empty for the one with which the page began; and what was there when that was left.
  const { state } = window.history as { state: unknown };
  let here = location.hash === "" && typeof state === "string" ? state : location.hash;
  let begun: Kept | null = null;
  const leave = (link: string): void => {
    if (here === "") begun = asKept(app);
    here = link;
  };
  const read = async (link: string): Promise<void> => {
    const found = await documentOf(link);
    if (found === null) return;
    if (typeof found === "string") return notice(badLink(found));
    app.history.change({ text: found.text, form: found.form ?? "", drawing: found.drawing ?? "" });
    app.view.set(found.view ?? FINISHED);
    app.student.set(found.student ?? false);
    app.task.set(found.task ?? null);
    app.board.set(found.board ?? null);
    store.keep(asKept(app), app.history.past());
    if (found.panel !== undefined) app.show(found.panel);
  };
  clean(here);
  window.addEventListener("hashchange", () => {
    if (!/^#\d+=/.test(location.hash)) return;
    leave(location.hash);
    clean(here);
    void read(here);
  });
  window.addEventListener("popstate", ({ state }: { state: unknown }) => {
    // The entry of a new link has no state yet.
    if (typeof state !== "string") return;
    leave(state);
    if (state !== "") void read(state);
    else if (begun !== null) takeUp(app, begun);
  });
}

/** Which panel is open at first: a student’s; the link's, the one that was open, else the first where there is room. */
function firstPanel(app: App, { shared, from }: Beginning, store: Store): void {
  if (app.student.value) return app.show(STUDENTS_PANEL);
  const known = (id: string | null | undefined): id is string => PANELS.some((panel) => panel.id === id);
  const before = from === "link" ? null : store.preference("panel");
  const roomy = window.innerWidth >= 960 ? (PANELS[0]?.id ?? "") : "";
  app.show(known(shared?.panel) ? shared.panel : known(before) && window.innerWidth >= 960 ? before : roomy);
}

/** Offers what somebody has made of the lesson before; undo leads back to the lesson. */
function offer(app: App, kept: Kept): void {
  const when = new Date(kept.time).toLocaleString(language.value, { dateStyle: "medium", timeStyle: "short" });
  const message = say("worked_before", { title: kept.title || say("untitled"), when });
  notice(message, [say("take_up"), () => takeUp(app, kept)]);
}

/** Goes on with what was kept. */
function takeUp(app: App, { text, form, drawing = "", student, task, board }: Kept): void {
  app.history.change({ text, form, drawing });
  app.student.set(student ?? false);
  app.task.set(task ?? null);
  app.board.set(board ?? null);
}

async function start(): Promise<void> {
  const store = browserStore();
  language.set(usual(store.preference("language")));
  language.on((now) => (document.documentElement.lang = now));
  sayAll(document);
  theme(store);
  const tell = teller();
  const script = await window.unpacked("worker", "text/javascript").text();
  // It is compiled while it is unpacked.
  const compiled = WebAssembly.compileStreaming(window.unpacked("engine", "application/wasm"));
  const first = await beginning(location.hash, store);
  const restarted = (why: Why): string => say(why, { seconds: PATIENCE / 1000 });
  const { engine, busy, stop } = startEngine(script, await compiled, (why, during) => {
    // Of a text that cannot be solved the message bar tells.
    if (during !== "open") notice(restarted(why));
    return restarted(why);
  });
  working(busy, stop);
  const app = application(first.shared ?? (await firstKind(engine)), first.from === "reload" ? store.past() : [], engine, tell);
  studying(app);
  wire(app, store);
  solving(app);
  tabs(app, PANELS, store);
  const tours = tour(app, store);
  help(app, store, tours.begin);
  splitter(store);
  firstPanel(app, first, store);
  watchAddress(app, store);
  autosave(app, store);
  if (first.bad !== null) notice(badLink(first.bad));
  else if (!store.works) notice(say("no_storage"));
  else if (first.before !== null) offer(app, first.before);
  else if (first.from === "autosave") tell(say("restored"));
  courseNotices(app);
  // Whoever comes by a lesson or a link came for that.
  if (first.from === "kind" && store.works && store.preference("tour") === null) tours.begin();
  if (first.from === "link") store.keep(asKept(app), app.history.past());
  (window as unknown as { kinegon: object }).kinegon = { app, engine, history: app.history, frames };
  const ready = (is: boolean): void => {
    if (is) document.documentElement.dataset["ready"] = "yes";
  };
  app.picture.on((picture) => ready(picture !== null));
  app.solved.on(({ refused }) => ready(refused !== null));
  void loadFonts(engine).catch(() => undefined);
}

start().catch((error: unknown) => {
  const place = byId("message");
  place.hidden = false;
  place.textContent = say("start_failed", { why: error instanceof Error ? error.message : String(error) });
});
