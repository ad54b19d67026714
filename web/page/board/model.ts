/** What the board knows: the drawing, the entry under way, what the engine says of both. The drawing's text is the only state that is kept. */
import type { App } from "../app.ts";
import { said } from "../refused.ts";
import { DRAWN_ON, type Sheet } from "../sheets.ts";
import { newest } from "../state/newest.ts";
import { signal, type Signal } from "../state/signal.ts";
import { goodText } from "../state/solving.ts";
import type { BoardUse } from "../state/address.ts";
import { begunWith, useOf } from "./begun.ts";
import { drawingOf, drawingText, standing, type Drawing, type Entry } from "./file.ts";
import { isTurning, named, rubbed, written } from "./entries.ts";
import { begun, lacking, type Tool } from "./tools.ts";
import type { Board, Ghost, Snapped } from "../engine/types.ts";
import { say } from "./words.ts";

/** What is shown over a sheet besides what is drawn. */
export interface Shown {
  sheet: Sheet;
  ghost: readonly Ghost[];
  kind: "hint" | "entry";
}

/** What the engine says of the drawing, and the scene of which it says that: only of this one more can be asked. */
export interface Known extends Board {
  readonly scene: string;
}

export interface Model {
  /** What the engine says of the drawing; null before it has said anything. */
  readonly known: Signal<Known | null>;
  readonly tool: Signal<Tool>;
  /** The entry under way. */
  readonly has: Signal<Entry>;
  /** The sheet that is shown alone; empty where all are. */
  readonly alone: Signal<Sheet | "">;
  /** The first sheet that is drawn on. */
  drawnOn(): Sheet;
  /** Where one sheet is shown at a time, shows that on which the entry of this index draws. */
  showSheetOf(index: number): void;
  /** How many entries are shown; null for all. */
  readonly until: Signal<number | null>;
  /** Another drawing that is looked at in place of the own: the program's, or somebody else's. */
  readonly looked: Signal<string | null>;
  /** The own drawing before another file was opened; null where none was. */
  readonly replaced: Signal<string | null>;
  readonly shown: Signal<Shown | null>;
  /** The drawing that is shown: with the entry under way where only the name of its point is missing, so that it is seen what is to be named. */
  readonly pictured: Signal<string>;
  /** What is said below: why something was refused, or what to do. */
  readonly says: Signal<{ text: string; isBad: boolean }>;
  /** Whether the entry under way is a rate of which all is said but its sense. */
  readonly wantsSense: Signal<boolean>;
  /** Points so near to each other that a press may have meant any of them; empty where none was. */
  readonly between: Signal<readonly Snapped[]>;
  readonly canUndo: Signal<boolean>;
  readonly canRedo: Signal<boolean>;
  use(): BoardUse;
  drawing(): Drawing;
  text(): string;
  choose(tool: Tool): void;
  /** Another value in the entry under way. */
  fill(entry: Entry): void;
  /** Takes what a press has added: the entry is written where all is said. */
  take(snap: Snapped): Promise<boolean>;
  /** Writes the entry under way, with a name of the board's own where one may be missing. */
  write(): Promise<boolean>;
  undo(): Promise<void>;
  redo(): Promise<void>;
  /** Takes the entry with this index back, and all after it. */
  undoFrom(index: number): Promise<void>;
  /** Begins with another drawing. */
  open(text: string): Promise<boolean>;
  /** The head of the file with something else in it. */
  head(part: Partial<Drawing>): void;
  /** One thing after the other. */
  inTurn(act: () => unknown): Promise<void>;
}

/** What a point is called that has no name yet. */
const NAMELESS = "?";

export function model(app: App): Model {
  const known = signal<Known | null>(null);
  const tool = signal<Tool>("lay_off");
  const has = signal<Entry>(begun("lay_off"));
  const says = signal({ text: "", isBad: false });
  const pictured = signal("");
  const wantsSense = signal(false);
  const between = signal<readonly Snapped[]>([]);
  const canUndo = signal(false);
  const canRedo = signal(false);
  const until = signal<number | null>(null);
  const looked = signal<string | null>(null);
  const replaced = signal<string | null>(null);
  /** What was undone last, the last of it at the end; anything else that is written clears it. */
  let undone: Entry[] = [];
  let opened = performance.now();
  let turn: Promise<unknown> = Promise.resolve();

  const scene = (): string => app.solved.value.good;
  const text = (): string => app.history.now.value.drawing ?? "";
  const drawing = (): Drawing => drawingOf(known.value?.drawing ?? text()) ?? { kinegon_drawing: 1, did: [] };
  const use = (): BoardUse => useOf(app);

  function show(next: Board, scene: string): void {
    known.set({ ...next, scene });
    canUndo.set(standing(drawing().did).length > 0);
    canRedo.set(undone.length > 0);
  }

  /** Another drawing comes in place of this one, which can be had back. */
  function replace(): void {
    if (known.value !== null && drawing().did.length > 0) replaced.set(known.value.drawing);
    undone = [];
    until.set(null);
  }

  const asking = newest(async (of: string) => {
    const good = scene();
    if (good === "") return;
    try {
      const found = await app.engine.board(good, of);
      show(of === "" ? await app.engine.board(good, begunWith(app, found.drawing)) : found, good);
      // Of a file that somebody brings: what is beyond stands there, and is not drawn.
      if (found.refused !== null) says.set({ text: `${found.refused.entry + 1}: ${found.refused.message}`, isBad: true });
    } catch (refused) {
      says.set({ text: said(refused), isBad: true });
    }
  });

  /** Puts the drawing with more entries in place of this one, unless the engine refuses the last of them. */
  async function put(entries: Entry[]): Promise<boolean> {
    const of = known.value;
    if (looked.value !== null || of === null) return false;
    const now = drawing();
    const t = Math.max(0, Math.round(performance.now() - opened));
    const next = drawingText({ ...now, did: [...now.did, ...entries.map((entry) => ({ ...entry, t }))] });
    try {
      const found = await app.engine.board(of.scene, next);
      if (found.refused !== null && found.refused.entry >= now.did.length) {
        says.set({ text: found.refused.message, isBad: true });
        return false;
      }
      until.set(null);
      show(found, of.scene);
      app.history.draw(found.drawing);
      return true;
    } catch (refused) {
      says.set({ text: said(refused), isBad: true });
      return false;
    }
  }

  /** Where one sheet is shown at a time, shows that on which an entry draws. */
  function showSheetOf(index: number): void {
    const on = known.value?.things.find(({ entry }) => entry === index)?.sheet;
    if (own.alone.value !== "" && on !== undefined && on !== "scheme") own.alone.set(on);
  }

  async function write(): Promise<boolean> {
    const board = known.value;
    if (board === null) return false;
    const entry = named(tool.value, has.value, board);
    const slot = lacking(tool.value, entry);
    if (slot !== undefined) {
      says.set({ text: say(`wants_${slot.takes}`), isBad: true });
      return false;
    }
    // A rate is a size and a sense; who means the sign that comes out says so.
    if (tool.value === "compute" && isTurning(entry["compute"], board) && entry["sense"] === undefined) {
      wantsSense.set(true);
      says.set({ text: say("wants_sense"), isBad: false });
      return false;
    }
    const entries = tool.value === "rub" ? rubbed(entry, drawing().did, board) : [written(entry, board)];
    if (entries === null || !(await put(entries))) return false;
    undone = [];
    canRedo.set(false);
    showSheetOf(drawing().did.length - 1);
    has.set(begun(tool.value, entry));
    const words = tool.value === "rub" ? say("rubbed", { name: String(entry["rub"]) }) : (known.value?.did.at(-1)?.words ?? "");
    says.set({ text: words, isBad: false });
    app.speak(words);
    return true;
  }

  async function undo(): Promise<void> {
    const { did } = drawing();
    const last = standing(did).at(-1);
    if (last === undefined) return;
    const { t: _, ...entry } = did[last] as Record<string, unknown>;
    if (!(await put([{ undo: 1 }]))) return;
    undone = [...undone, entry];
    canRedo.set(true);
    says.set({ text: say("undone"), isBad: false });
    app.speak(say("undone"));
  }

  const own: Model = {
    known,
    tool,
    has,
    alone: signal<Sheet | "">(""),
    showSheetOf,
    drawnOn: () => known.value?.sheets.find(({ sheet }) => sheet !== "scheme")?.sheet ?? DRAWN_ON[0]!,
    until,
    looked,
    replaced,
    pictured,
    shown: signal<Shown | null>(null),
    says,
    wantsSense,
    between,
    canUndo,
    canRedo,
    use,
    drawing,
    text,
    choose(next) {
      wantsSense.set(false);
      between.set([]);
      tool.set(next);
      has.set(begun(next));
      own.shown.set(null);
      says.set({ text: say(`how_${next}`), isBad: false });
    },
    fill(entry) {
      wantsSense.set(false);
      between.set([]);
      has.set(entry);
      if (says.value.isBad) says.set({ text: "", isBad: false });
    },
    async take(snap) {
      const entry = snap.entry as Entry;
      own.fill(entry);
      if (known.value === null) return false;
      const next = lacking(tool.value, named(tool.value, entry, known.value));
      if (snap.is_whole && next === undefined) return write();
      // What the hand does next.
      if (next !== undefined) says.set({ text: say(`wants_${next.takes}`), isBad: false });
      return false;
    },
    write,
    undo,
    async redo() {
      const next = undone.at(-1);
      if (next === undefined || !(await put([next]))) return;
      undone = undone.slice(0, -1);
      canRedo.set(undone.length > 0);
      app.speak(say("redone"));
    },
    async undoFrom(index) {
      const count = standing(drawing().did).filter((each) => each >= index).length;
      undone = [];
      if (count > 0 && (await put([{ undo: count }]))) says.set({ text: say("undone"), isBad: false });
    },
    async open(next) {
      if (drawingOf(next) === null) return false;
      try {
        const good = await goodText(app);
        const found = await app.engine.board(good, next);
        replace();
        show(found, good);
        app.history.draw(found.drawing);
        return true;
      } catch (refused) {
        says.set({ text: said(refused), isBad: true });
        return false;
      }
    },
    head(part) {
      const next = drawingText({ ...drawing(), ...part });
      // It is the same drawing, and none that comes in its place.
      if (known.value !== null) known.set({ ...known.value, drawing: next });
      app.history.draw(next);
      asking.want(next);
    },
    inTurn(act) {
      turn = turn.then(act, act);
      return turn.then(
        () => undefined,
        () => undefined,
      );
    },
  };

  function picture(): void {
    const now = known.value?.drawing ?? "";
    const slot = lacking(tool.value, has.value);
    const isNameless = slot?.takes === "point_name" && (tool.value !== "mark" || has.value["drawn"] !== undefined) && until.value === null && looked.value === null;
    pictured.set(isNameless ? drawingText({ ...drawing(), did: [...drawing().did, slot.set(has.value, NAMELESS)] }) : now);
  }
  known.on(picture);
  has.on(picture);
  until.on(picture);

  // Another drawing, or another scene.
  let last = "";
  const follow = (): void => {
    if (!app.drawing.value) return;
    const { refused } = app.solved.value;
    if (scene() === "") return void (refused !== null && says.set({ text: said(refused), isBad: true }));
    const wanted = looked.value ?? text();
    const now = `${scene()}\n${wanted}`;
    if (now === last) return;
    const isOtherScene = !last.startsWith(`${scene()}\n`);
    last = now;
    if (!isOtherScene && known.value?.drawing === wanted) return;
    if (!isOtherScene && looked.value === null) replace();
    asking.want(wanted);
  };
  app.drawing.on((is) => {
    // Time runs on from where it was left.
    if (is) opened = performance.now() - Number(drawing().did.at(-1)?.["t"] ?? 0);
    last = "";
    follow();
  });
  app.history.now.on(follow);
  app.solved.on(follow);
  looked.on(follow);
  return own;
}
