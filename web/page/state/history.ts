import { withHintsOf } from "../panels/check/form.ts";
import { signal, type Signal } from "./signal.ts";

/** What the person makes: everything that undo goes through. */
export interface Document {
  /** The scene's text, as a file of the program has it. */
  readonly text: string;
  /** The student's form of measured values, as a file of the program has it; empty before anything is written. */
  readonly form: string;
  /** What the student draws on the board, as a file of the program has it; empty or missing before anything is drawn. It has an undo of its own. */
  readonly drawing?: string;
}

/** Most entries that are kept. */
const MOST = 500;

/** The document with all that it was: one entry a gesture. */
export interface History {
  /** What undo goes back through, the oldest first; after a reload it is there again. */
  past(): readonly Document[];
  readonly now: Signal<Document>;
  readonly canUndo: Signal<boolean>;
  readonly canRedo: Signal<boolean>;
  /** Changes a part. Changes with the same gesture, one after the other, are one entry. */
  change(part: Partial<Document>, gesture?: string): void;
  /** Goes on with the drawing: no entry, for undo of the page leaves it as it is as long as the scene is the same. */
  draw(drawing: string): void;
  undo(): void;
  redo(): void;
}

export function history(first: Document, before: readonly Document[] = []): History {
  const now = signal(first);
  const canUndo = signal(before.length > 0);
  const canRedo = signal(false);
  let past: Document[] = [...before];
  let future: Document[] = [];
  let last: string | undefined;

  function show(document: Document): void {
    canUndo.set(past.length > 0);
    canRedo.set(future.length > 0);
    now.set(document);
  }

  /** A document of before or after, with the drawing as far as it is now, and with the hints that were opened. */
  function returned(document: Document): Document {
    const { text, form, drawing } = now.value;
    if (document.text !== text) return document;
    return { ...document, form: withHintsOf(document.form, form), ...(drawing === undefined ? {} : { drawing }) };
  }

  return {
    past: () => past,
    now,
    canUndo,
    canRedo,
    change(part, gesture) {
      const next = { ...now.value, ...part };
      if (next.text === now.value.text && next.form === now.value.form && (next.drawing ?? "") === (now.value.drawing ?? "")) return;
      if (gesture === undefined || gesture !== last) past = [...past, now.value].slice(-MOST);
      last = gesture;
      future = [];
      show(next);
    },
    draw: (drawing) => now.set({ ...now.value, drawing }),
    undo() {
      const before = past.at(-1);
      if (before === undefined) return;
      past = past.slice(0, -1);
      future = [now.value, ...future];
      last = undefined;
      show(returned(before));
    },
    redo() {
      const [after, ...rest] = future;
      if (after === undefined) return;
      past = [...past, now.value];
      future = rest;
      last = undefined;
      show(returned(after));
    },
  };
}
