import type { BoardUse, Task } from "./address.ts";
import type { Document } from "./history.ts";
import { thisPage, type Page } from "./lesson.ts";

/** What a course asks: the scene, and the form when it was empty. */
export interface Asked {
  text: string;
  form: string;
}

/** A document as it is kept. */
export interface Kept extends Document {
  title: string;
  /** Whether it came by a student's link. */
  student?: boolean;
  /** The exercise that it is. */
  task?: Task | null;
  /** How the drawing board is used, where a link has said it. */
  board?: BoardUse | null;
  /** What it was asked for with, where a course has asked. */
  asked?: Asked;
  /** The page in which it was made; those of older versions do not say. */
  page?: Page;
  /** When it was kept, in ms since 1970. */
  time: number;
}

/** Where documents are kept. */
export interface Store {
  /** Whether anything is kept at all. */
  readonly works: boolean;
  /** What this very tab had on this page before it was loaded again, or before it went elsewhere; a tab that was duplicated has what the other had. */
  own(): Kept | null;
  /** What other tabs have or had, the newest first. */
  others(): Kept[];
  /** Keeps a document, with what undo goes back through. */
  keep(document: Kept, past: readonly Document[]): void;
  /** What undo goes back through, of the document that this tab had before it was loaded again. */
  past(): Document[];
  forgetOthers(): void;
  /** A preference, such as dark or light. */
  preference(name: string): string | null;
  prefer(name: string, value: string): void;
}

const PREFIX = "kinegon:1:";
/** How many documents are kept. */
const MOST = 12;

function parsed(text: string | null): Kept | null {
  try {
    const kept = JSON.parse(text ?? "null") as Kept | null;
    return typeof kept?.text === "string" && typeof kept.form === "string" ? kept : null;
  } catch {
    return null;
  }
}

/** Most letters of what undo goes back through that are kept: a browser keeps some five million in all. */
const MOST_LETTERS = 1_000_000;

/** As many of the last documents as may be kept. */
function newest(past: readonly Document[]): Document[] {
  let letters = 0;
  const first = past.findLastIndex(({ text, form, drawing = "" }) => (letters += text.length + form.length + drawing.length) > MOST_LETTERS);
  return past.slice(first + 1);
}

/** Documents that were kept as a list. */
function listed(text: string | null): Document[] {
  try {
    const all = JSON.parse(text ?? "[]") as unknown;
    const isDocument = (one: unknown): one is Document => typeof (one as Document | null)?.text === "string" && typeof (one as Document).form === "string";
    return Array.isArray(all) ? all.filter(isDocument) : [];
  } catch {
    return [];
  }
}

/** The browser's storage, or a store that keeps nothing where the browser forbids it. */
export function store(): Store {
  try {
    return browserStore(window.localStorage, window.sessionStorage);
  } catch {
    return nothing();
  }
}

function nothing(): Store {
  return {
    works: false,
    own: () => null,
    others: () => [],
    keep: () => undefined,
    past: () => [],
    forgetOthers: () => undefined,
    preference: () => null,
    prefer: () => undefined,
  };
}

/** Each tab keeps its document under a name of its own, so that none destroys another's. */
function browserStore(local: Storage, session: Storage): Store {
  local.setItem(`${PREFIX}try`, "1");
  local.removeItem(`${PREFIX}try`);
  const isReload = (performance.getEntriesByType("navigation")[0] as PerformanceNavigationTiming | undefined)?.type === "reload";
  // A tab may go from one page to another and back: it has one document for each.
  const name = `${PREFIX}tab:${thisPage().address}`;
  const before = session.getItem(name);
  // A tab that was duplicated has the other's name in its session, but was not loaded again: it keeps its own under another name.
  const tab = before !== null && isReload ? before : `${PREFIX}doc:${crypto.randomUUID()}`;
  session.setItem(name, tab);

  const own = before === null ? null : parsed(local.getItem(before));
  // Of this tab alone: it goes with it.
  const undo = `${PREFIX}past:${thisPage().address}`;
  const past = own === null ? [] : listed(session.getItem(undo));

  const names = (): string[] => Object.keys(local).filter((name) => name.startsWith(`${PREFIX}doc:`) && name !== tab);
  const others = (): [string, Kept][] =>
    names()
      .map((name): [string, Kept | null] => [name, parsed(local.getItem(name))])
      .filter((entry): entry is [string, Kept] => entry[1] !== null)
      .sort(([, a], [, b]) => b.time - a.time);

  return {
    works: true,
    own: () => own,
    others: () => others().map(([, kept]) => kept),
    past: () => past,
    keep(document, before) {
      try {
        session.setItem(undo, JSON.stringify(newest(before)));
      } catch {
        session.removeItem(undo);
      }
      for (const [name] of others().slice(MOST - 1)) local.removeItem(name);
      try {
        local.setItem(tab, JSON.stringify(document));
      } catch {
        // Full: the oldest goes, once.
        const oldest = others().at(-1);
        if (oldest === undefined) return;
        local.removeItem(oldest[0]);
        try {
          local.setItem(tab, JSON.stringify(document));
        } catch {
          // A document that is too large for the browser is not kept.
        }
      }
    },
    forgetOthers: () => names().forEach((name) => local.removeItem(name)),
    preference: (name) => local.getItem(PREFIX + name),
    prefer(name, value) {
      try {
        local.setItem(PREFIX + name, value);
      } catch {
        // Full: then it holds for this time only.
      }
    },
  };
}
