/** The editor of the scene's text. Undo is the page's own. */
import { closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap } from "@codemirror/commands";
import { json } from "@codemirror/lang-json";
import { bracketMatching, foldGutter, foldKeymap, indentOnInput, indentUnit } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, type Extension } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers } from "@codemirror/view";
import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import type { Refused } from "../../engine/types.ts";
import { editor as phrasesOf } from "../../sentences.ts";
import { language } from "../../words.ts";
import { newId } from "../parts/fields.ts";
import { smallest } from "./change.ts";
import { edited, endsOf, filed, placed } from "./ends.ts";
import { hasLongLine } from "./lines.ts";
import { look } from "./look.ts";
import { meanings, offers } from "./offers.ts";
import { piles } from "./piles.ts";
import { say } from "./words.ts";

/** How long after a letter the scene is solved, and after how long a pause typing is a new entry of undo, in ms. */
const WAIT = 150;
const PAUSE = 1200;

/** Marks changes that come from elsewhere. */
const elsewhere = Annotation.define<boolean>();

export interface TextEditor {
  view: EditorView;
  /** Selects a place of the file's text and goes there. */
  go(from: number, to: number): void;
}

/** The text as it is in the editor: none where a browser could not lay it out. */
const shown = (text: string): string => (hasLongLine(text) ? "" : edited(text));

export function textEditor(parent: HTMLElement, app: App): TextEditor {
  const phrases = new Compartment();
  const typing = typist(app);
  const undone = (what: "undo" | "redo") => () => (typing.flush(), app.history[what](), true);
  const extensions: Extension[] = [
    keymap.of([
      { key: "Mod-z", run: undone("undo"), preventDefault: true },
      { key: "Mod-y", mac: "Mod-Shift-z", run: undone("redo"), preventDefault: true },
      { key: "Ctrl-Shift-z", run: undone("redo"), preventDefault: true },
      ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...foldKeymap, ...lintKeymap, ...defaultKeymap,
    ]),
    lineNumbers(), foldGutter(), lintGutter(), highlightActiveLineGutter(), highlightActiveLine(), drawSelection(), highlightSpecialChars(), piles,
    json(), indentUnit.of("  "), indentOnInput(), bracketMatching(), closeBrackets(), highlightSelectionMatches(), search({ top: true }),
    offers, meanings, look, phrases.of([]),
    EditorView.lineWrapping,
    EditorView.domEventHandlers({ blur: () => typing.flush() }),
    EditorView.updateListener.of((update) => {
      const isTyped = update.docChanged && !update.transactions.some((transaction) => transaction.annotation(elsewhere) === true);
      if (isTyped) typing.typed(update.state.doc.toString());
    }),
  ];
  const view = new EditorView({ parent, state: EditorState.create({ doc: shown(app.history.now.value.text), extensions }) });
  language.on((now) => {
    const own = EditorState.phrases.of(Object.fromEntries(Object.entries(phrasesOf[now]).map(([key, phrase]) => [key.replaceAll("_", " "), phrase])));
    view.dispatch({ effects: phrases.reconfigure([own, EditorView.contentAttributes.of({ "aria-label": say("editor"), lang: "zxx", tabindex: "0" })]) });
  });
  app.history.now.on(({ text }) => {
    const next = shown(text);
    const now = view.state.doc.toString();
    // The newest letters win: they are handed over in a moment.
    if (next === now || typing.isWaiting()) return;
    view.dispatch({ changes: smallest(now, next), annotations: elsewhere.of(true) });
  });
  app.solved.on(({ text, refused }) => {
    if (edited(text) === view.state.doc.toString()) view.dispatch(setDiagnostics(view.state, marks(text, refused)));
  });
  return {
    view,
    go(from, to) {
      const { text } = app.history.now.value;
      const most = view.state.doc.length;
      const [anchor, head] = [from, to].map((place) => Math.min(placed(text, place), most)) as [number, number];
      view.focus();
      view.dispatch({ selection: { anchor, head }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
    },
  };
}

/** Why the text is refused, at its place. */
function marks(text: string, refused: Refused | null): Parameters<typeof setDiagnostics>[1] {
  if (refused === null || refused.from === null) return [];
  const from = placed(text, refused.from);
  const to = Math.max(from, placed(text, refused.to ?? refused.from));
  const { message, hint } = refused;
  const renderMessage = (): Node => element("div", {}, message, hint !== null && element("div", { class: "hint" }, hint));
  return [{ from, to, severity: "error", message: hint === null ? message : `${message} ${hint}`, renderMessage }];
}

/** Hands over what is typed: soon, and at once when the editor or the page is left. */
function typist(app: App): { typed(text: string): void; flush(): void; isWaiting(): boolean } {
  let waiting: string | null = null;
  let gesture = newId();
  let timer = 0;
  let last = 0;
  const flush = (): void => {
    window.clearTimeout(timer);
    if (waiting === null) return;
    const text = filed(waiting, endsOf(app.history.now.value.text));
    waiting = null;
    app.history.change({ text }, gesture);
  };
  window.addEventListener("pagehide", flush);
  document.addEventListener("visibilitychange", flush);
  return {
    flush,
    typed(text) {
      const now = Date.now();
      if (now - last > PAUSE) gesture = newId();
      last = now;
      waiting = text;
      window.clearTimeout(timer);
      timer = window.setTimeout(flush, WAIT);
    },
    isWaiting: () => waiting !== null,
  };
}
