import type { ExerciseOptions, View } from "../engine/types.ts";

/** The exercise that a scene is: what it was made from, so that its sheet, and the next one, can be made again. */
export interface Task {
  /** The name of its kind, or of the scene that was varied. */
  name: string;
  /** That scene's text; empty for a kind of the page's own. */
  text: string;
  seed: number;
  /** Counted from 1. */
  number: number;
  options: ExerciseOptions;
  /** Whether the teacher lets the steps of the construction be read. */
  steps: boolean;
  /** Whether the teacher lets the student go on with the next ones. */
  more: boolean;
}

/** How the drawing board is used: the teacher's link says it. It deters, it is no safe. */
export interface BoardUse {
  /** To practise with checks and hints; as an exam, of which nothing is told; to look on while it is drawn. */
  mode: (typeof BOARD_MODES)[number];
  /** What the hand is helped with: places and lines, places alone, nothing. */
  snap: (typeof SNAPS)[number];
  /** Whether a wrong operation is told at once; else when it is asked for. Only to practise. */
  at_once: boolean;
  /** The text of the scene whose drawing has been handed in; this page keeps it, and no link says it. */
  handed_in?: string;
}
const BOARD_MODES = ["practice", "exam", "demonstration"] as const;
const SNAPS = ["all", "points", "none"] as const;

/** What a link holds. */
export interface Shared {
  /** The scene's text. */
  text: string;
  /** The form of measured values, where one goes along. */
  form?: string;
  /** What is drawn on the board, where that goes along. */
  drawing?: string;
  /** How the board is used; none where the link is not about it. */
  board?: BoardUse | null;
  view?: View;
  /** The panel that is shown at first. */
  panel?: string;
  /** Whether it is for a student: nothing is shown that the sheet asks for. */
  student?: boolean;
  task?: Task | null;
}

/** Why a link cannot be read. */
export type BadLink = "broken" | "newer" | "too_large";

/** The version of links; its number stands before the document, as in `#1=…`. */
const VERSION = 1;

/** As many letters as a scene may have (docs/scenes.md), and a form besides. */
const MOST = 5 << 20;

const through = (bytes: BufferSource | string, by: CompressionStream | DecompressionStream): ReadableStream<Uint8Array> =>
  new Blob([bytes]).stream().pipeThrough(by as ReadableWritablePair<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>);

/** The part of an address after #, with the document in it. */
export async function hashOf(shared: Shared): Promise<string> {
  const stream = through(JSON.stringify(shared), new CompressionStream("deflate-raw"));
  const packed = new Uint8Array(await new Response(stream).arrayBuffer());
  let letters = "";
  for (const byte of packed) letters += String.fromCharCode(byte);
  return `#${VERSION}=${btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

/** The text of a stream, unless it is longer than anybody writes. */
async function limited(stream: ReadableStream<Uint8Array>): Promise<string | null> {
  const decoder = new TextDecoder("utf-8", { fatal: true });
  const reader = stream.getReader();
  let text = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    text += decoder.decode(value, { stream: true });
    if (text.length > MOST) {
      void reader.cancel();
      return null;
    }
  }
}

/** What somebody else's JSON holds of a document; null where that is no document. */
function document(json: unknown): Shared | null {
  const given = (typeof json === "object" && json !== null ? json : {}) as Record<string, unknown>;
  if (typeof given["text"] !== "string") return null;
  const shared: Shared = { text: given["text"] };
  if (typeof given["form"] === "string") shared.form = given["form"];
  if (typeof given["drawing"] === "string") shared.drawing = given["drawing"];
  const use = useOf(given["board"]);
  if (use !== null) shared.board = use;
  if (typeof given["panel"] === "string") shared.panel = given["panel"];
  if (given["student"] === true) shared.student = true;
  const task = taskOf(given["task"]);
  if (task !== null) shared.task = task;
  const view = given["view"] as Partial<View> | null | undefined;
  if (typeof view === "object" && view !== null) {
    const step = Number.isInteger(view.step) && (view.step as number) > 0 ? (view.step as number) : null;
    shared.view = { step, coarse: view.coarse === true, modes: view.modes === true };
  }
  return shared;
}

/** How the board is used, as somebody else's JSON says it; null where it says nothing that is known. */
function useOf(json: unknown): BoardUse | null {
  const given = (typeof json === "object" && json !== null ? json : {}) as Record<string, unknown>;
  const mode = BOARD_MODES.find((known) => known === given["mode"]);
  const snap = SNAPS.find((known) => known === given["snap"]) ?? "all";
  return mode === undefined ? null : { mode, snap, at_once: given["at_once"] === true };
}

/** An exercise as somebody else's JSON names it; null where it names none. */
function taskOf(json: unknown): Task | null {
  const given = (typeof json === "object" && json !== null ? json : {}) as Record<string, unknown>;
  const { name, text = "", seed, number } = given;
  const isWhole = (value: unknown, least: number): value is number => Number.isSafeInteger(value) && (value as number) >= least;
  if (typeof name !== "string" || typeof text !== "string" || !isWhole(seed, 0) || !isWhole(number, 1)) return null;
  const asked = (typeof given["options"] === "object" && given["options"] !== null ? given["options"] : {}) as Record<string, unknown>;
  const word = (key: string): string | null => (typeof asked[key] === "string" ? asked[key] : null);
  const options = { page: word("page"), language: word("language"), notation: word("notation"), decimal: word("decimal") };
  return { name, text, seed, number, options, steps: given["steps"] === true, more: given["more"] === true };
}

declare const HOSTED: string | undefined;

/** Where a page with nothing in it is that links lead to: this one; of a page that was opened from a file, the one in the web, if its place is known. */
export function baseOf(address: string, hosted = typeof HOSTED === "string" ? HOSTED : ""): string {
  return address.startsWith("file:") && hosted !== "" ? hosted : address.replace(/#.*/s, "");
}

/** The document of a link; null where the address holds none. */
export async function documentOf(hash: string): Promise<Shared | BadLink | null> {
  const [, version, letters] = /^#(\d+)=(.*)$/s.exec(hash) ?? [];
  if (version === undefined || letters === undefined) return null;
  if (Number(version) > VERSION) return "newer";
  try {
    const packed = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    const text = await limited(through(packed, new DecompressionStream("deflate-raw")));
    return text === null ? "too_large" : (document(JSON.parse(text)) ?? "broken");
  } catch {
    return "broken";
  }
}
