import type { HandedIn } from "./board/class.ts";
import type { EngineClient } from "./engine/client.ts";
import type { Opened, Picture, Pins, Refused, SheetPicture, View } from "./engine/types.ts";
import type { Broken } from "./motion/film.ts";
import type { Sheet } from "./sheets.ts";
import type { BoardUse, Shared, Task } from "./state/address.ts";
import type { Course } from "./state/course.ts";
import type { History } from "./state/history.ts";
import type { Signal } from "./state/signal.ts";
import type { Asked } from "./state/storage.ts";

/** What the engine says of the present text. */
export interface Solved {
  /** The text that it is about. */
  text: string;
  /** What is known of it; of a text that is refused, of the last good one. */
  opened: Opened | null;
  /** The last good text, which the picture shows. */
  good: string;
  /** Why it is refused; null where it is good. */
  refused: Refused | null;
}

/** What all parts of the page share. */
export interface App {
  /** Where its elements are: the page, or what is within the component. */
  root: Document | ShadowRoot;
  history: History;
  engine: EngineClient;
  solved: Signal<Solved>;
  /** Whether a number is being typed just now: what is refused meanwhile is not complained of, for it may be half a number. */
  typing: Signal<boolean>;
  view: Signal<View>;
  /** Whether the picture is the sheet of paper that is saved and printed; else it is laid out for the screen, at scales of its own. */
  paper: Signal<boolean>;
  /** The panel that is large; empty where all share the room. */
  focus: Signal<Sheet | "">;
  /** Points whose paths are in the picture on the screen while their curves are looked at. */
  traced: Signal<string[]>;
  /** The picture on the screen, also while something is dragged; null before the first. */
  picture: Signal<Picture | null>;
  /** Whether it is drawn in the colours of a dark screen. */
  dark: Signal<boolean>;
  /** Whether pulling a joint changes lengths in place of moving the mechanism. */
  shaping: Signal<boolean>;
  pins: Signal<Pins>;
  /** Whether the hand Build is chosen: in place of the picture the mechanism is put together. */
  building: Signal<boolean>;
  /** A point, a link or a load (by its number from 0) whose card in the form of the mechanism is to be seen; `types`: and its number typed. The panel sets it to null. */
  card: Signal<{ of: "point" | "link" | "load"; name: string; types: boolean } | null>;
  /** Whether the page was opened by a student's link, which shows no answers by itself. */
  student: Signal<boolean>;
  /** The exercise that the student's scene is; null where the link names none. */
  task: Signal<Task | null>;
  /** How the drawing board is used, where a link has said it. */
  board: Signal<BoardUse | null>;
  /** Whether an exam is under way: nothing is judged, hinted or shown until the work is handed in. */
  exam: Signal<boolean>;
  /** The drawings of a class that somebody brings. */
  handed: Signal<readonly HandedIn[]>;
  /** Whether the drawing board is shown. */
  drawing: Signal<boolean>;
  /** The course that has opened the page; null where none has. */
  course: Course | null;
  /** What that course asks. */
  asked: Asked;
  /** Says something aloud and for a moment on the page. */
  tell(message: string): void;
  /** Says something aloud, for screen readers alone. */
  speak(message: string): void;
  /** Shows the panel of this id. */
  show(panel: string): void;
  /** The panel that is shown; empty where none is. */
  shown: Signal<string>;
  /** A place in the text where the eye shall go, in UTF-16 units; the text panel follows and sets it to null. */
  place: Signal<{ from: number; to: number } | null>;
  /** A form or a marking scheme that somebody brings; the panel of the check takes it and sets it to null. */
  brought: Signal<{ name: string; text: string } | null>;
  /** A picture that somebody brings; the panel of the check takes it for a photograph and sets it to null. */
  photographed: Signal<File | null>;
  /** Films the drives as they run until they begin again, or to and fro once; null where the browser cannot. */
  film: (() => Promise<Blob | Broken>) | null;
  /** Opens a scene that somebody brings, in place of the present document; undo brings that back. */
  open(text: string): void;
  /** The address of this page with a document in it. */
  link(shared: Shared): Promise<string>;
  /** Prints sheets at their true size, each on a page of its own. */
  print(sheets: readonly SheetPicture[]): void;
}

/** What the picture, its steps and its motion need of it: all that the component has. */
export type Shown = Pick<App, "root" | "history" | "engine" | "solved" | "typing" | "view" | "paper" | "picture" | "dark" | "shaping" | "pins" | "building" | "student" | "tell" | "speak">;

/** A panel beside the picture. */
export interface Panel {
  id: string;
  title(): string;
  /** Fills the panel once; it keeps itself current through the app's signals. */
  mount(root: HTMLElement, app: App): void;
}
