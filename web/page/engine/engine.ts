import type {
  Board,
  BoardHint,
  BoardJudged,
  BoardPictureAsk,
  CheckOptions,
  Checked,
  Curves,
  Drafted,
  DraftedView,
  Edit,
  Exercise,
  ExerciseOptions,
  FileRequest,
  Form,
  Grab,
  Kind,
  MarkedPoint,
  Mode,
  Opened,
  OverCycle,
  Pane,
  Panel,
  PhotoRead,
  Picture,
  PlacedPoint,
  PointVerdict,
  Pressed,
  Proposed,
  Pull,
  Running,
  SheetPicture,
  Snapped,
  Tapped,
  Value,
  View,
} from "./types.ts";

/** The engine: what the worker does. Every function takes the scene's text; the last one is kept solved. A refusal rejects with {@link Refused}. */
export interface Engine {
  kinds(): Kind[];
  /** A face of the letters that drawings are set with, as OpenType. */
  font(is_italic: boolean): Uint8Array;
  open(text: string): Opened;
  picture(text: string, view: View): Picture;
  /** How the scene runs; null where no drive has a speed. */
  running(text: string): Running | null;
  /** Takes hold; the sheet's layout stays until `drop`. */
  grab(text: string, view: View, what: Grab): Picture;
  drag(to: Pull): Picture;
  /** The scene's text after the gesture. */
  drop(): string;
  edit(text: string, edits: Edit[]): string;
  /** Where the points are in the scene's own coordinates: as solved; of a scene that cannot be solved, those that its text says. */
  places(text: string): { name: string; at: [number, number] }[];
  /** What is known of a scene, complete or not, with its picture: links, guides, fixed points, drives, no plans. */
  drafted(text: string, view: DraftedView): Drafted;
  /** As `edit`; where the scene is not complete after it, the text says roughly where points were. */
  edit_in_place(text: string, edits: Edit[]): string;
  /** The lines of a load's table, each a place and a factor, as a spreadsheet writes them; of several columns that with the load's name. */
  load_table(table: string, load: string): [number, number][];
  /** The scene's text with points at other places, complete or not. */
  move_points(text: string, moves: PlacedPoint[]): string;
  modes(text: string): Mode[];
  /** The scene in another assembly mode: its text with `near` changed. */
  choose_mode(text: string, number: number): string;
  /** On a part of the screen. */
  curves(text: string, of: OverCycle, pane: Pane): Curves;
  /** Values with certain digits: what `kinegon solve --digits` prints, by rows. */
  values(text: string): Value[];
  file(text: string, request: FileRequest): Uint8Array;
  /** The form of a scene; `filled` is a form with values, or empty. */
  form(text: string, filled: string): Form;
  /** A form file, JSON or a table, as JSON with the names by which the scene's form asks. */
  read_form(text: string, form: string): string;
  /** A form as a table. */
  write_form(text: string, form: string): string;
  /** How many sheets of paper a drawing takes: a work sheet's table may stand on a second one. */
  pages(text: string, of: Exclude<FileRequest["of"], string>): number;
  check(text: string, form: string, options: CheckOptions): Checked;
  /** The exercise of a number, counted from 1; `name` is that of the kind or of the scene's file. */
  exercise(text: string, name: string, seed: number, number: number, options: ExerciseOptions): Exercise;
  /** A sheet of an exercise as PDF. */
  exercise_file(text: string, name: string, seed: number, number: number, options: ExerciseOptions, what: "sheet" | "key"): Uint8Array;
  /** The sheet in a photograph of that many pixels, by their brightness row by row; it is kept for the next three. `name` is that of the exercise, or empty. The pixels are handed over and gone here. */
  photo(text: string, name: string, width: number, height: number, grey: Uint8Array): PhotoRead;
  /** The points that its pencil lines show; they are looked for once, which takes a moment. */
  photo_proposed(): Proposed[];
  /** The place in a plan that is tapped in the picture: where pencil lines cross at most `reach` mm from there, else there; null where that is not on the sheet. */
  photo_tap(plan: Panel, x: number, y: number, reach: number, aim: number): Tapped | null;
  /** How points of the student's plans stand in it. */
  photo_points(placed: MarkedPoint[]): PointVerdict[];
  /** What a drawing is: its sheets, what stands on them, what it has to choose from; an empty text begins one. */
  board(text: string, drawing: string): Board;
  /** What a press at a place of a sheet adds to the entry under way, the nearest first. */
  board_snap(text: string, drawing: string, ask: Pressed): Snapped[];
  /** A sheet as it is after so many entries. */
  board_picture(text: string, drawing: string, ask: BoardPictureAsk): SheetPicture;
  /** What is right and what is wrong, entry by entry. */
  board_judge(text: string, drawing: string): BoardJudged;
  /** What could come next: 1 where, 2 by which relation, 3 the operation itself. */
  board_hint(text: string, drawing: string, level: number): BoardHint;
  /** The form of measured values that a drawing is. */
  board_form(text: string, drawing: string): string;
  /** The program's own construction as a drawing. */
  board_own(text: string): string;
  /** The plans of a drawing on sheets of paper, with their markers, as one PDF; `name` is that of the exercise. */
  board_sheets(text: string, drawing: string, name: string): Uint8Array;
}
