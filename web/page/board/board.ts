/** The drawing board: the student draws the plans, over all of the page. It is made when it is first asked for. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { icon } from "../dom/icon.ts";
import { radios } from "../dom/radios.ts";
import { button, worded } from "../dom/worded.ts";
import { askedFor, textOf } from "../files/open.ts";
import { name } from "../layout/say.ts";
import { noteAnswers } from "../panels/check/told.ts";
import { orTell, said } from "../refused.ts";
import { called, DRAWN_ON, type Sheet } from "../sheets.ts";
import { goodText } from "../state/solving.ts";
import { language } from "../words.ts";
import { classList } from "./class.ts";
import { drawingOf } from "./file.ts";
import { handing } from "./handing.ts";
import { hands } from "./hands.ts";
import { judging } from "./judging.ts";
import { keys } from "./keys.ts";
import { list } from "./list.ts";
import { model, type Model } from "./model.ts";
import { rail } from "./rail.ts";
import { replay } from "./replay.ts";
import { stage, type Stage } from "./stage.ts";
import { strip } from "./strip.ts";
import { say, type Saying } from "./words.ts";

/** Narrower than this one sheet is shown at a time. */
const NARROW = "(max-width: 959.9px)";
/** The scheme, and those that are drawn on: forces are not yet. */
const ALL: readonly Sheet[] = ["scheme", ...DRAWN_ON];

/** Shows the board as `app.drawing` says; nothing of it is there before. */
export function board(app: App): void {
  let made: { show(is: boolean): void } | null = null;
  app.drawing.on((is) => {
    if (is) made ??= builds(app);
    made?.show(is);
  });
  // What is drawn after the answers were seen says so.
  let wasOpen = false;
  app.drawing.on((is) => {
    const isTold = app.student.value && app.board.value?.mode === "exam" && !app.exam.value;
    if (wasOpen && !is && isTold) void orTell(app, () => noteAnswers(app, "drawing"));
    wasOpen = is;
  });
  // A link that is about the board leads there.
  app.board.on((use) => use !== null && app.student.value && app.drawing.set(true));
}

function builds(app: App): { show(is: boolean): void } {
  const own = model(app);
  const told = judging(app, own);
  const stages = ALL.map((sheet) => stage(app, own, told, sheet));
  const back = (): void => stages.find(({ sheet }) => sheet === (own.alone.value || own.drawnOn()))?.over.focus({ preventScroll: true });
  const below = strip(own, back);
  const sheets = element("div", { class: "sheets" }, ...stages.map(({ root }) => root));
  const drawer = element("div", { class: "drawer" }, classList(app, own), list(own, told));
  const root = element("section", { id: "board", hidden: true }, worded(element("h1", { class: "unseen" }), () => say("title")), head(app, own, told, drawer), rail(own), sheets, drawer, replay(app, own), below.root);
  worded(root, () => say("title"), "aria-label");
  document.body.append(root);
  hands(app, own, stages);
  const close = (): void => app.drawing.set(false);
  keys(app, own, stages, below.focusWritten);
  const arrange = (): void => arranged(own, stages, sheets);
  own.alone.on(arrange);
  own.known.on((known) => {
    if (own.alone.value !== "" && known !== null && !known.sheets.some(({ sheet }) => sheet === own.alone.value)) own.alone.set(own.drawnOn());
    arrange();
    // The sheets are there now, and have the keys.
    if (!root.hidden && !root.contains(document.activeElement)) back();
  });
  own.shown.on((shown) => shown?.kind === "hint" && own.alone.value !== "" && own.alone.set(shown.sheet));
  // Who looks on has no tools.
  const looks = (): void => void root.classList.toggle("looking", own.until.value !== null || own.looked.value !== null);
  own.until.on(looks);
  own.looked.on(looks);
  const narrow = window.matchMedia(NARROW);
  const fits = (): void => own.alone.set(narrow.matches ? own.alone.value || own.drawnOn() : "");
  narrow.addEventListener("change", fits);

  root.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && !event.altKey && (key === "z" || key === "y")) {
      event.preventDefault();
      void own.inTurn(key === "y" || event.shiftKey ? own.redo : own.undo);
    } else if (event.key === "Escape" && root.querySelector(":popover-open, dialog[open]") !== null) {
      // The browser closes what is open over the board, and no more.
    } else if (event.key === "Escape" && !event.defaultPrevented) {
      event.preventDefault();
      // First what is under way goes, then the board.
      if (Object.values(own.has.value).some((value) => typeof value === "string" && value !== "")) own.choose(own.tool.value);
      else close();
    }
    // What has keys here is no business of the page below.
    event.stopPropagation();
  });

  /** In a demonstration there is something to look at from the beginning; else the own drawing. */
  function look(): void {
    own.looked.set(null);
    own.until.set(null);
    if (!root.hidden && own.use().mode === "demonstration") void demonstrate(app, own);
  }
  app.board.on(look);
  let opener: Element | null = null;
  return {
    show(is) {
      if (is === !root.hidden) return;
      if (is) opener = document.activeElement;
      root.hidden = !is;
      document.body.classList.toggle("drawing", is);
      for (const id of ["toolbar", "main", "side"]) document.getElementById(id)!.inert = is;
      if (!is) return void (opener instanceof HTMLElement && opener.isConnected && opener.focus({ preventScroll: true }));
      fits();
      own.choose(own.tool.value);
      look();
      back();
    },
  };
}

/** What is looked at: the drawing that the link has, else the program's. */
async function demonstrate(app: App, own: Model): Promise<void> {
  if (drawingOf(own.text()) === null) return lookAtOwn(app, own);
  lookFromBeginning(own);
}

function lookFromBeginning(own: Model): void {
  own.until.set(0);
  own.says.set({ text: say("look_on"), isBad: false });
}

/** Looks at the program's construction, from its beginning. */
async function lookAtOwn(app: App, own: Model): Promise<void> {
  try {
    own.looked.set(await app.engine.board_own(await goodText(app)));
    lookFromBeginning(own);
  } catch (refused) {
    own.says.set({ text: said(refused), isBad: true });
  }
}

/** One sheet with the scheme as a card to pick links from, or all. */
function arranged(own: Model, stages: readonly Stage[], sheets: HTMLElement): void {
  const alone = own.alone.value;
  const there = new Set(own.known.value?.sheets.map(({ sheet }) => sheet));
  sheets.dataset["alone"] = alone;
  for (const { sheet, root } of stages) {
    root.hidden = !there.has(sheet) || (alone !== "" && sheet !== alone && sheet !== "scheme");
    root.classList.toggle("card", alone !== "" && sheet === "scheme" && alone !== "scheme");
  }
}

/** Back, undo, what is given, sheets, and what the mode lets be asked. */
function head(app: App, own: Model, told: ReturnType<typeof judging>, drawer: HTMLElement): HTMLElement {
  const tool = (saying: Saying, pictogram: string, press: () => void, id: string): HTMLButtonElement => {
    const made = element("button", { type: "button", id, onclick: press }, icon(pictogram));
    language.on(() => name(made, say(saying)));
    return made;
  };
  const close = tool("close", "back", () => app.drawing.set(false), "board-close");
  const undo = tool("undo", "undo", () => void own.inTurn(own.undo), "board-undo");
  const redo = tool("redo", "redo", () => void own.inTurn(own.redo), "board-redo");
  own.canUndo.on((can) => (undo.disabled = !can));
  own.canRedo.on((can) => (redo.disabled = !can));
  // What is scrolled is reached by keys, too.
  const given = element("p", { class: "given", tabindex: 0 });
  own.known.on((known) => (given.innerHTML = known?.given.map(({ label, value, unit }) => `<span>${label} = ${value} ${unit}</span>`).join(" ") ?? ""));
  const asks = (saying: Saying, pictogram: string, press: () => void, id: string): HTMLButtonElement => {
    const made = tool(saying, pictogram, press, id);
    made.append(worded(element("span", { class: "text" }), () => say(saying)));
    return made;
  };
  const hint = asks("hint", "help", () => void told.hint(), "board-hint");
  const check = asks("check", "check", told.check, "board-check");
  const handed = handing(app, own, told);
  const handIn = button(() => say("hand_in"), () => handed.ask(), { id: "board-hand-in", class: "main" });
  const openList = tool("list", "steps", () => openList.setAttribute("aria-pressed", String(drawer.classList.toggle("open"))), "board-open-list");
  openList.setAttribute("aria-pressed", "false");
  const more = files(app, own, told);
  const allow = (): void => {
    const { mode } = own.use();
    hint.hidden = check.hidden = mode !== "practice" || own.looked.value !== null;
    handIn.hidden = mode !== "exam" || own.looked.value !== null;
    undo.hidden = redo.hidden = mode === "demonstration" || own.looked.value !== null;
  };
  app.board.on(allow);
  own.looked.on(allow);
  return element("div", { class: "head" }, close, undo, redo, given, sheetSwitch(own), openList, hint, check, handIn, more, handed.root);
}

/** Which sheets are seen. */
function sheetSwitch(own: Model): HTMLElement {
  const values: (Sheet | "")[] = ["", ...ALL];
  const buttons = values.map((sheet) => worded(element("button", { type: "button", role: "radio", "data-value": sheet, onclick: () => own.alone.set(sheet) }), () => (sheet === "" ? say("all_sheets") : called(sheet, "short"))));
  const root = worded(element("div", { class: "switch which", role: "radiogroup" }, ...buttons), () => say("sheets"), "aria-label");
  radios(root);
  const show = (): void => {
    const there = new Set<Sheet | "">(["", ...(own.known.value?.sheets.map(({ sheet }) => sheet) ?? [])]);
    values.forEach((sheet, index) => {
      const one = buttons[index]!;
      one.hidden = !there.has(sheet);
      one.setAttribute("aria-checked", String(own.alone.value === sheet));
      one.tabIndex = own.alone.value === sheet ? 0 : -1;
    });
  };
  own.alone.on(show);
  own.known.on(show);
  return root;
}

/** Files, replay, the program's own construction. */
function files(app: App, own: Model, told: ReturnType<typeof judging>): HTMLElement {
  const menu = element("div", { class: "files", popover: "auto", id: "board-files" });
  const act = (saying: Saying, press: () => void): HTMLButtonElement => button(() => say(saying), () => (menu.hidePopover(), press()), { class: "entry" });
  const save = act("save", told.save);
  const open = act("open", () => void askedFor(".json,application/json").then(async (file) => {
    const text = file === null ? null : await textOf(file);
    if (text === null) return;
    if (drawingOf(text) === null) own.says.set({ text: say("no_drawing", { name: file!.name }), isBad: true });
    else await own.open(text);
  }));
  const sheets = act("sheets_pdf", () => void told.sheets());
  const into = act("into_form", () => void told.handIn());
  const again = act("replay", () => own.until.set(own.until.value === null ? 0 : null));
  const right = act("own_construction", () => {
    if (own.looked.value !== null) return own.looked.set(null), own.until.set(null);
    void lookAtOwn(app, own);
  });
  own.looked.on((text) => (right.textContent = say(text === null ? "own_construction" : "own_drawing")));
  const before = act("put_back", () => void own.open(own.replaced.value ?? ""));
  own.replaced.on((text) => (before.hidden = text === null));
  menu.append(save, open, before, sheets, into, again, right);
  const show = (): void => {
    right.hidden = app.student.value && own.use().mode !== "demonstration";
    again.hidden = own.use().mode === "exam";
    into.hidden = own.use().mode !== "practice";
  };
  app.student.on(show);
  app.board.on(show);
  const opens = element("button", { type: "button", popovertarget: "board-files", id: "board-more" }, icon("more"));
  language.on(() => name(opens, say("more")));
  return element("div", { class: "more" }, opens, menu);
}
