/** Why a text is not understood or a scene gives no result; places are in the text that was handed over. */
export interface Refused {
  /** What is wrong. */
  message: string;
  /** What to try. */
  hint: string | null;
  /** The JSON path, as `links.4.lengths.GD`; empty for the text as a whole. */
  path: string;
  /** Where it stands in the text, in UTF-16 units; null for the text as a whole. */
  from: number | null;
  to: number | null;
  /** Line and column, counted from 1. */
  line: number | null;
  column: number | null;
}

/** A starting scene. */
export interface Kind {
  name: string;
  title: string;
  text: string;
}

/** A drive and where it stands. */
export interface Drive {
  /** As in `kinegon sweep --drive`: a link, or a slider on a moving link such as 3/2. */
  name: string;
  is_angle: boolean;
  /** In degrees or units of length. */
  value: number;
  /** In words, as `70.0°`. */
  shown: string;
  /** The range that it can reach; null where it turns all the way round or slides without end. */
  low: number | null;
  high: number | null;
}

/** A step of the construction. */
export interface Step {
  /** Counted from 1. */
  number: number;
  caption: string;
  /** Its equation in plain text, or empty. */
  equation: string;
  /** `scheme`, `velocity`, `acceleration`. */
  panel: string;
}

/** What is known of a scene that could be solved. */
export interface Opened {
  title: string;
  /** The scene file as JSON. */
  scene: SceneFile;
  drives: Drive[];
  steps: Step[];
  /** Steps that a lecturer shows together: the numbers of the first and the last of each. */
  passages: [number, number][];
  /** What is done in each of them. */
  passage_captions: string[];
  /** Names of points whose paths can be drawn. */
  traceable: string[];
  /** Names of quantities for curves, tables and values. */
  quantities: string[];
  /** Names of vectors for hodographs. */
  vectors: string[];
  /** The Assur groups in solving order, as `kinegon structure` prints them. */
  structure: string;
  warnings: string[];
  /** Whether it is a drawn configuration, which cannot be moved. */
  is_drawn: boolean;
}

/** How a scene is shown besides what its `figure` says. */
export interface View {
  /** The step after which it is shown; null for the finished figure. */
  step: number | null;
  /** Whether steps are the passages. */
  coarse: boolean;
  /** Whether all other assembly modes are drawn pale. */
  modes: boolean;
  /** The panels that are shown (`scheme`, `velocity`, `acceleration`) in place of the figure's: a student's link shows the scheme alone. */
  panels?: string[] | null;
}

/** A place that can be taken hold of. */
export interface Handle {
  /** The point's name. */
  name: string;
  /** On the sheet, in mm from its upper left corner. */
  at: [number, number];
  is_fixed: boolean;
}

/** A picture of the scene in one position. */
export interface Picture {
  svg: string;
  /** Size of the sheet in mm. */
  width: number;
  height: number;
  /** By panel: its name in words, its key (`scheme`, `velocity`, `acceleration`), its box [x, y, width, height] in mm. */
  panels: { name: string; key: string; box: [number, number, number, number]; is_cut: boolean }[];
  handles: Handle[];
  drives: Drive[];
  /** What is to be told: a limit that stops the drive, a panel that is cut. */
  notes: string[];
}

/** What is taken hold of. */
export type Grab =
  /** A joint, to move the mechanism: the first drive follows. */
  | { kind: "move"; point: string }
  /** A drive. */
  | { kind: "drive"; drive: string }
  /** A joint, to change lengths (or the place of a fixed point); pinned joints stay, pinned lengths keep their values. */
  | { kind: "shape"; point: string; pins: Pins };

export interface Pins {
  /** Points that stay where they are. */
  points: string[];
  /** Lengths that stay, as `2.BC`: link and length. */
  lengths: string[];
}

/** Where to. */
export type Pull =
  /** A place on the sheet, in mm. */
  | { to: [number, number] }
  /** A value of the drive. */
  | { value: number };

/** One change of a scene's text. */
export type Edit =
  /** Puts a value at a JSON path, in place of what is there; `null` as the last value removes it. */
  | { set: (string | number)[]; value: unknown }
  | { remove: (string | number)[] }
  /** Gives a point, link or drive another name everywhere. */
  | { rename: "point" | "link"; from: string; to: string }
  /** A new link between points; those that are new get a place. */
  | { add_link: { points: { name: string; at: [number, number] }[] } }
  /** A further point of a link. */
  | { add_point: { link: string; name: string; at: [number, number] } }
  /** A pin that slides: of a link along a guide on the ground or another link. */
  | { add_slider: { link: string; at: string; on: string; along: number | string } }
  /** Removes a link, or a point, with all that names it. */
  | { drop_link: string }
  | { drop_point: string };

/** A way to assemble the scene. */
export interface Mode {
  number: number;
  /** The places of moving points, and angles of links, in words. */
  shown: string;
  is_own: boolean;
}

/** A file as the program writes it. */
export interface FileRequest {
  /** `csv` is the table of the motion, `json` the result, `steps` the text of the construction. */
  format: "svg" | "outlines" | "pdf" | "tikz" | "csv" | "json" | "steps";
  /**
   * What is drawn: the figure, the work sheet, its second sheet, the sheet after a step or passage (counted from 1); over the
   * cycle curves, paths, hodographs.
   */
  of: "figure" | "worksheet" | { worksheet: number } | { step: number } | { passage: number } | OverCycle;
}

/** What is drawn over the cycle, by names of quantities, points, vectors. */
export type OverCycle = { curves: string[] } | { path: string[]; beyond_limits?: boolean } | { hodograph: string[] };

/** What can be drawn over the cycle. */
export interface Curves {
  svg: string;
  width: number;
  height: number;
  /** Extremes, dead centres, limits, in words. */
  events: string[];
  /** The axis of the drive; null where nothing is drawn over it. */
  axis?: DriveAxis | null;
}

/** Where the values of the drive are in graphs one above the other. */
export interface DriveAxis {
  /** The value at the left edge of the graphs, in degrees or units of length. */
  low: number;
  /** At the right edge. */
  high: number;
  /** The graphs: [x, y, width, height] in mm. */
  areas: [number, number, number, number][];
}

/** A box of the form of measured values. */
export interface FormRow {
  /** The name under which its value stands in the form file. */
  name: string;
  /** As letters with scripts, as the sheet shows it: HTML of `<i>`, `<sub>`, `<sup>` and text alone. */
  label: string;
  unit: string;
  /** `scheme`, `velocity`, `acceleration`. */
  panel: string;
  /** The step that gives it, and that step's caption. */
  step: number;
  caption: string;
  /** Whether it has a sense, which a sign tells. */
  has_sense: boolean;
  /** Whether that sense is one of rotation. */
  turns: boolean;
  /** Whether it can be given in mm of paper, with `/mu` behind its name. */
  on_paper: boolean;
  /** Whether the empty form asks for it. */
  is_asked: boolean;
}

/** A point of a plan: its name in the form file, and as the sheet shows it. */
export interface PlanPoint {
  name: string;
  label: string;
}

export interface Form {
  /** In the order of the construction; behind them those of further values of a filled form. */
  rows: FormRow[];
  /** Scales of the sheet: units per mm of paper. */
  mu_l: number | null;
  mu_v: number | null;
  mu_a: number | null;
  /** By plan: the pole and the points whose places can be given. */
  points: { velocity: PlanPoint[]; acceleration: PlanPoint[] };
  /** The empty form, as `kinegon check --template` writes it. */
  json: string;
  csv: string;
}

/** A form that was checked. All texts of its parts are HTML of `<sub>`, `<sup>` and text alone. */
export interface Checked {
  /** As `kinegon check --json`; null where no value is understood. */
  result: CheckResult | null;
  /** As `kinegon check`. */
  report: string;
  /** The report piece by piece. */
  parts: ReportParts | null;
  /** Values that are not understood, by their names in the form; the others are checked. */
  faults: { name: string; message: string; hint: string | null }[];
  /** The student's drawing over the right one, where it was asked for. */
  overlays: { svg: string; width: number; height: number }[];
  /** The page that `--feedback` writes, where it was asked for. */
  feedback: string;
  /** The marks, where a marking scheme was given, in words. */
  marks: string | null;
}

/** A report piece by piece. */
export interface ReportParts {
  /** How many values are right, within the tolerance, off. */
  counts: string;
  /** How much is allowed, and how accurate the drawing is. */
  accuracy: string[];
  /** Headings of a value's cells. */
  columns: string[];
  /** The values in the order of `result.values`: the box of each, and name, own value, right value, difference, on paper, per cent, allowed, verdict. */
  rows: { name: string; cells: string[] }[];
  senses: string | null;
  heading: string;
  /** What was probably done, the step's caption, what it should be, what follows from it. */
  causes: { done: string; caption: string | null; should: string; follows: string | null }[];
  sure: string | null;
  further: string[];
  others: string[];
}

export interface CheckOptions {
  /** Marking scheme, as for `kinegon check --marks`, or null. */
  marks: string | null;
  /** Tolerance of the pencil, in mm and degrees; null for what the sheet shows. */
  pencil_mm: number | null;
  pencil_degrees: number | null;
  /** Whether overlays and feedback are made, too. */
  drawn: boolean;
}

/** How exercises are written, as the options of `kinegon exercise`; null: as the scene has it. */
export interface ExerciseOptions {
  page: string | null;
  language: string | null;
  notation: string | null;
  decimal: string | null;
}

/** An exercise: the files of its folder, and the sizes of its sheets in mm. */
export interface Exercise {
  /** Its scene. */
  text: string;
  name: string;
  sheet: string;
  width: number;
  height: number;
  key: string;
  key_width: number;
  key_height: number;
  /** The empty form, also as a table, and the key's values. */
  form: string;
  form_csv: string;
  key_values: string;
}

/** A scene file, as docs/scenes.md has it. */
// eslint-disable-next-line
export type SceneFile = Record<string, any>;
/** `kinegon schema check`. */
export type CheckResult = Record<string, any>;


/** A value of the scene's own position. */
export interface Value {
  /** Its name, as `v(D).size`. */
  name: string;
  /** As letters with scripts: HTML of `<i>`, `<sub>`, `<sup>` and text alone. */
  label: string;
  /** Those digits that are certain. */
  value: string;
  unit: string;
  /** How far the value can be from the true one, in the same unit; absent where that is not known. */
  error?: string | null;
}
