/** What the engine says of a drawing. Places are in mm of a sheet from its upper left corner, y down. */
import type { Sheet } from "../sheets.ts";
import type { Entry } from "./file.ts";

export interface BoardSheet {
  sheet: Sheet;
  width: number;
  height: number;
  pole: [number, number] | null;
  /** Its scale in words. */
  scale: string;
}

/** Something that can be pointed at. */
export interface Thing {
  sheet: Sheet;
  kind: "point" | "line" | "link" | "guide";
  name: string;
  label: string;
  words: string;
  /** Its outline, as SVG. */
  path: string;
  at: [number, number];
  entry: number | null;
}

export interface BoardNumber {
  name: string;
  label: string;
  value: string;
  unit: string;
  entry: number | null;
}

export interface BoardName {
  sheet: Sheet | null;
  kind: "point" | "number";
  name: string;
  label: string;
  is_made: boolean;
}

export interface BoardEntry {
  words: string;
  sheet: Sheet | null;
  stands: boolean;
  /** The entries whose results it uses. */
  needs: number[];
}

export interface Board {
  drawing: string;
  given: BoardNumber[];
  sheets: BoardSheet[];
  things: Thing[];
  numbers: BoardNumber[];
  names: BoardName[];
  free: { line: string; point: string; number: string };
  did: BoardEntry[];
  refused: { entry: number; message: string } | null;
}

export interface Ghost {
  kind: "line" | "square" | "arrow" | "point" | "angle";
  path: string;
}

export interface SnapAsk {
  has: Entry;
  sheet: Sheet;
  at: [number, number];
  reach: number;
}

export interface Snap {
  entry: Entry;
  is_whole: boolean;
  words: string;
  at: [number, number];
  ghost: Ghost[];
}

export interface BoardPictureAsk {
  sheet: Sheet;
  until: number | null;
  letters: number | null;
  judged: boolean;
}

export interface JudgedEntry {
  index: number;
  does: string;
  verdict: "right" | "wrong" | "follows" | "unused" | "undone";
  says?: string | null;
  done?: string | null;
  should?: string | null;
}

export interface BoardJudged {
  entries: JudgedEntry[];
  first_wrong?: number | null;
  is_complete: boolean;
}

export interface BoardHint {
  words: string;
  sheet: Sheet | null;
  ghost: Ghost[];
  entry: number | null;
}
