// What goes into the engine and comes out of it. Made from engine/schema.json by types.mjs: web/README.md says how.

/**
 * A part of the figure.
 */
export type Panel = "scheme" | "velocity" | "acceleration" | "centers" | "forces" | "lever" | "speeds";
/**
 * A kind of thing that has quantities.
 */
export type Owner = "link" | "slider" | "point" | "others";
/**
 * What is taken hold of.
 */
export type Grab =
  | {
      kind: "move";
      /**
       * The joint.
       */
      point: string;
    }
  | {
      kind: "drive";
      /**
       * The drive.
       */
      drive: string;
    }
  | {
      kind: "run";
      /**
       * The drive that is pulled.
       */
      drive: string;
    }
  | {
      kind: "shape";
      /**
       * The joint.
       */
      point: string;
      /**
       * What stays.
       */
      pins: Pins;
    };
/**
 * Where to.
 */
export type Pull =
  | {
      /**
       * In mm.
       *
       * @minItems 2
       * @maxItems 2
       */
      to: [number, number];
    }
  | {
      /**
       * In degrees or units of length.
       */
      value: number;
    };
/**
 * One change of a scene's text.
 */
export type Edit =
  | {
      /**
       * The path: keys, and indices of lists.
       */
      set: Key[];
      /**
       * The value.
       */
      value: unknown;
    }
  | {
      /**
       * The path.
       */
      remove: Key[];
    }
  | {
      /**
       * What is renamed.
       */
      rename: Named;
      /**
       * Its name.
       */
      from: string;
      /**
       * Its new name.
       */
      to: string;
    }
  | {
      /**
       * The link.
       */
      add_link: NewLink;
    }
  | {
      /**
       * The point.
       */
      add_point: NewPoint;
    }
  | {
      /**
       * The slider.
       */
      add_slider: NewSlider;
    }
  | {
      /**
       * Its name.
       */
      drop_link: string;
    }
  | {
      /**
       * Its name.
       */
      drop_point: string;
    };
/**
 * A step of a JSON path.
 */
export type Key = number | string;
/**
 * What has a name.
 */
export type Named = "point" | "link";
/**
 * The direction of a new guide.
 */
export type Along = number | string;
/**
 * A kind of file: `outlines` is SVG without letters, for a canvas that makes a PNG of it; `csv` is the table of the motion, `json` the result, `steps` the text of the construction.
 */
export type Format = "svg" | "outlines" | "pdf" | "tikz" | "csv" | "json" | "steps";
/**
 * What is drawn.
 */
export type Subject =
  | SheetName
  | {
      /**
       * Counted from 1; a table without room beside the panels is on the second.
       */
      worksheet: number;
    }
  | {
      /**
       * Counted from 1.
       */
      step: number;
    }
  | {
      /**
       * Counted from 1.
       */
      passage: number;
    }
  | OverCycle;
/**
 * A sheet.
 */
export type SheetName = "figure" | "worksheet";
/**
 * What is drawn over the cycle of the first drive, by names of quantities, points, vectors.
 */
export type OverCycle =
  | {
      /**
       * Their names; without any those that the scene wants, or all ω.
       */
      curves: string[];
    }
  | {
      /**
       * Their names.
       */
      path: string[];
      /**
       * Whether the paths go on beyond limits of the drive.
       */
      beyond_limits?: boolean;
    }
  | {
      /**
       * Their names.
       */
      hodograph: string[];
    };
/**
 * What can be pointed at.
 */
export type ThingKind = "point" | "line" | "link" | "guide";
/**
 * What a name is of.
 */
export type NameKind = "point" | "number";
/**
 * What is not drawn yet.
 */
export type GhostKind = "line" | "square" | "arrow" | "point";
/**
 * The word for a verdict in results.
 */
export type DrawingVerdict = "right" | "wrong" | "follows" | "unused" | "undone";
/**
 * An error that all measured lengths have in common.
 */
export type CommonErrorResult =
  | {
      scale: number;
    }
  | {
      zero: number;
    };
/**
 * What the place of a point in a photograph tells.
 */
export type PlaceVerdict = "right" | "off" | "open";
/**
 * A unit of length.
 */
export type SceneLengthUnit = "m" | "mm" | "cm" | "in" | "ft";
/**
 * A unit of time.
 */
export type SceneTimeUnit = "s" | "min";
/**
 * A unit of mass.
 */
export type SceneMassUnit = "kg" | "g" | "t" | "lb" | "slug" | "blob";
/**
 * A unit of force.
 */
export type SceneForceUnit = "N" | "kN" | "mN" | "kgf" | "lbf";
export type SceneGround =
  | {
      [k: string]: SceneVector;
    }
  | string[];
/**
 * [x, y], or size and angle
 */
export type SceneVector = [number, number] | SceneSizeAngle;
export type SceneLink = SceneLinkFields | string[];
/**
 * Coordinates in the link's own frame; a lone number is the distance along the link's axis
 */
export type SceneShapePoint = SceneVector | number;
/**
 * The name of a point, or coordinates
 */
export type SceneNameOrPlace = string | SceneVector;
/**
 * A point of the link; coordinates in its own frame, in a drawn configuration in the fixed frame; or a distance along its axis
 */
export type SceneLinkPlace = string | SceneVector | number;
/**
 * Two points of the guide's carrier as "BE" or "B-E"; or degrees; or [dx, dy]
 */
export type SceneDirection = string | number | SceneVector;
/**
 * A number of teeth, that of a ring negative; or "rack"
 */
export type SceneTeeth = number | "rack";
/**
 * How a belt, a rope or a chain runs around two wheels.
 */
export type SceneBelt = "open" | "crossed";
/**
 * Lines, or the path of a CSV file that the program reads
 */
export type SceneLoadTable = SceneTableLine[] | string;
/**
 * A place and the factor there
 *
 * @minItems 2
 * @maxItems 2
 */
export type SceneTableLine = [number, number];
/**
 * An end of a spring in the file: a link or "ground", and a place of it.
 *
 * @minItems 2
 * @maxItems 2
 */
export type SceneSpringEnd = [unknown, unknown];
/**
 * Whether inertia counts among the loads.
 */
export type SceneAnalysis = "dynamic" | "static";
/**
 * Approximate coordinates of a point; under a key like angle(3), degrees
 */
export type SceneNearValue = SceneVector | number;
/**
 * A part of the figure.
 */
export type ScenePanel = "scheme" | "velocity" | "acceleration" | "centers" | "forces" | "lever" | "speeds";
/**
 * The plans for which scales are chosen that the scene does not give.
 */
export type SceneScalesFor = "position" | "sheet" | "cycle";
/**
 * A drawing style that comes with the program.
 */
export type SceneStyleName = "paper" | "print" | "lecture" | "board";
/**
 * Notation of poles, images and parts of accelerations. Names of quantities stay the same.
 */
export type SceneNotation = "paper" | "english" | "russian" | "german";
/**
 * How the motion along a guide is written.
 */
export type SceneSliding = "slider" | "points";
/**
 * The index of the Coriolis part of an acceleration.
 */
export type SceneCoriolis = "c" | "C" | "k" | "cor";
/**
 * The letter of instant centres.
 */
export type SceneCenter = "P" | "I" | "CIR";
/**
 * The number of the frame, in place of the word for it.
 */
export type SceneFrame = "0" | "1";
/**
 * The sense in which the velocity plan is turned by 90°.
 */
export type SceneTurned = "counter-clockwise" | "clockwise";
/**
 * A language of headings and captions.
 */
export type SceneLanguage = "en" | "es" | "de" | "pt";
/**
 * Decimal mark of the numbers on figures and in the text of steps; results always have points.
 */
export type SceneDecimal = "point" | "comma";
/**
 * Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end
 */
export type SceneConstruction = boolean | "paper";
/**
 * Whether values stand at vectors and links; a unit of length: in this unit, as "m" for m/s
 */
export type SceneValues = boolean | ("m" | "mm" | "cm" | "in" | "ft");
/**
 * "all", or centres by their links, as ["P(2,ground)", "P(1,3)"]
 */
export type SceneCenters = "all" | string[];

/**
 * Why a text is not understood or a scene gives no result.
 */
export interface Refused {
  /**
   * What is wrong.
   */
  message: string;
  /**
   * What to try.
   */
  hint: string | null;
  /**
   * The JSON path, as `links.4.lengths.GD`; empty for the text as a whole.
   */
  path: string;
  /**
   * Where it begins in the text, in UTF-16 units as JavaScript counts; none for the text as a whole.
   */
  from: number | null;
  /**
   * Where it ends.
   */
  to: number | null;
  /**
   * Line, counted from 1.
   */
  line: number | null;
  /**
   * Column in characters, counted from 1.
   */
  column: number | null;
}
/**
 * A starting scene.
 */
export interface Kind {
  /**
   * Its name, as `kinegon new` has it.
   */
  name: string;
  /**
   * Its title.
   */
  title: string;
  /**
   * Its text.
   */
  text: string;
}
/**
 * What is known of a scene that could be solved.
 */
export interface Opened {
  /**
   * Its title, or the usual one.
   */
  title: string;
  /**
   * The scene file as JSON.
   */
  scene: SceneFile;
  /**
   * Its drives and where they stand.
   */
  drives: Drive[];
  /**
   * The steps of the construction; none of a scene that is too large for them.
   */
  steps: Step[];
  /**
   * Steps that a lecturer shows together: the numbers of the first and the last of each.
   */
  passages: [number, number][];
  /**
   * What is done in each passage.
   */
  passage_captions: string[];
  /**
   * Names of points whose paths can be drawn.
   */
  traceable: string[];
  /**
   * Quantities for curves, tables and values; vectors for hodographs, too.
   */
  quantities: Quantity[];
  /**
   * Those that the scene wants by itself.
   */
  wanted: Quantity[];
  /**
   * The Assur groups in solving order, as `kinegon structure` prints them.
   */
  structure: string;
  /**
   * The panels of its figure.
   */
  panels: Panel[];
  /**
   * Warnings of all stages.
   */
  warnings: string[];
  /**
   * Whether it is a drawn configuration, which cannot be moved.
   */
  is_drawn: boolean;
}
/**
 * A drive and where it stands.
 */
export interface Drive {
  /**
   * A driven link, or a slider on a moving link such as 3/2.
   */
  name: string;
  /**
   * Whether it turns.
   */
  is_angle: boolean;
  /**
   * In degrees or units of length.
   */
  value: number;
  /**
   * In words, as `70.0°`.
   */
  shown: string;
  /**
   * The least value that it can reach; none where it turns all the way round or slides without end.
   */
  low: number | null;
  /**
   * The greatest.
   */
  high: number | null;
}
/**
 * A step of the construction.
 */
export interface Step {
  /**
   * Counted from 1.
   */
  number: number;
  /**
   * What is done.
   */
  caption: string;
  /**
   * Its equation in plain text, or empty.
   */
  equation: string;
  /**
   * What it gives besides, in plain text, a line each: sizes and directions, rates, angles of crossings.
   */
  values: string[];
  /**
   * The panel in which it is drawn.
   */
  panel: Panel;
}
/**
 * A quantity by its name, and what the name says.
 */
export interface Quantity {
  /**
   * Its whole name, as `v(D).size`.
   */
  name: string;
  /**
   * What stands before the parenthesis, as `v`.
   */
  head: string;
  /**
   * What stands in it, as `D`.
   */
  inside: string;
  /**
   * What stands behind it, as `.size`; mostly nothing.
   */
  part: string;
  /**
   * What kind of thing has it, which `inside` names.
   */
  of: Owner;
  /**
   * Whether it is a vector.
   */
  is_vector: boolean;
}
/**
 * How a scene is shown besides what its `figure` says.
 */
export interface View {
  /**
   * The step after which it is shown, from 1; none for the finished figure.
   */
  step: number | null;
  /**
   * Whether steps are the passages.
   */
  coarse: boolean;
  /**
   * Whether all other assembly modes are drawn pale.
   */
  modes: boolean;
  /**
   * The panels that are shown in place of the figure's: a student's link shows the scheme alone. What is no panel is passed over.
   */
  panels?: Panel[] | null;
  /**
   * The part of the screen for which it is laid out; none for the figure's paper, as in its file.
   */
  pane?: Pane | null;
  /**
   * The panel that has most of a part of the screen; none where all share it.
   */
  focus?: Panel | null;
  /**
   * Points whose paths are drawn in the scheme besides those of the figure. What has no path is passed over.
   */
  trace?: string[];
  /**
   * How far the layout has gone from that of the last gesture to its own, from 0 to 1; none where it is there.
   */
  eased?: number | null;
}
/**
 * A part of the screen, in pixels.
 */
export interface Pane {
  /**
   * Its width.
   */
  width: number;
  /**
   * Its height.
   */
  height: number;
  /**
   * Height of the em of its letters.
   */
  letters: number;
  /**
   * Whether the words of steps stand on it.
   */
  words: boolean;
}
/**
 * A picture of the scene in one position.
 */
export interface Picture {
  /**
   * The sheet.
   */
  svg: string;
  /**
   * Width of the sheet in mm.
   */
  width: number;
  /**
   * Height of the sheet in mm.
   */
  height: number;
  /**
   * Its panels.
   */
  panels: PicturePanel[];
  /**
   * What can be taken hold of: the points of the mechanism.
   */
  handles: Handle[];
  /**
   * The drives and where they stand.
   */
  drives: Drive[];
  /**
   * What is to be told: a limit that stops the drive, a panel that is cut.
   */
  notes: string[];
}
/**
 * A panel of a picture.
 */
export interface PicturePanel {
  /**
   * Its name in words.
   */
  name: string;
  /**
   * Which panel it is.
   */
  key: Panel;
  /**
   * [x, y, width, height] in mm.
   *
   * @minItems 4
   * @maxItems 4
   */
  box: [number, number, number, number];
  /**
   * Whether something is cut off at its edge.
   */
  is_cut: boolean;
}
/**
 * A place that can be taken hold of.
 */
export interface Handle {
  /**
   * The point's name.
   */
  name: string;
  /**
   * The panel in which it is.
   */
  panel: Panel;
  /**
   * On the sheet, in mm from its upper left corner.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * Whether it never moves: a point of the ground, or a pole.
   */
  is_fixed: boolean;
}
/**
 * How a scene runs: all its drives together, in proportion to their speeds.
 */
export interface Running {
  /**
   * The drive by whose value the others are told: the first that has a speed.
   */
  drive: string;
  /**
   * Whether its value falls.
   */
  is_backwards: boolean;
  /**
   * The least value that it can reach; none where it turns all the way round or slides without end.
   */
  low: number | null;
  /**
   * The greatest.
   */
  high: number | null;
  /**
   * The turns after which the mechanism is where it began; none where it never is, or goes to and fro.
   */
  turns: number | null;
}
/**
 * What stays when a joint is pulled.
 */
export interface Pins {
  /**
   * Points that stay where they are.
   */
  points: string[];
  /**
   * Lengths that stay, as `2.BC`: link and length; or a link's angle, as `1.angle`.
   */
  lengths: string[];
}
/**
 * A new link.
 */
export interface NewLink {
  /**
   * Its points. One that the scene has already becomes a joint.
   */
  points: PlacedPoint[];
}
/**
 * A point where it is, or is to be, in the present position.
 */
export interface PlacedPoint {
  /**
   * Its name.
   */
  name: string;
  /**
   * Its place in the fixed frame, in units of length.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
}
/**
 * A further point of a link.
 */
export interface NewPoint {
  /**
   * The link, or `ground`.
   */
  link: string;
  /**
   * The point's name.
   */
  name: string;
  /**
   * Its place in the present position, in the fixed frame.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
}
/**
 * A new slider.
 */
export interface NewSlider {
  /**
   * The sliding link; empty for a pin in a slot.
   */
  link: string;
  /**
   * The point of it that is on the guide, or the pin.
   */
  at: string;
  /**
   * What carries the guide: a link, or `ground`.
   */
  on: string;
  /**
   * The guide's direction: degrees, or two points of its carrier as `BE`.
   */
  along: Along;
}
/**
 * A point of the scene in its own coordinates.
 */
export interface Place {
  /**
   * Its name.
   */
  name: string;
  /**
   * Where it is, in units of length.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
}
/**
 * A way to assemble the scene.
 */
export interface Mode {
  /**
   * Its number, as `kinegon modes` counts.
   */
  number: number;
  /**
   * The places of moving points, and angles of links, in words; of many those alone that differ from the scene's own.
   */
  shown: string;
  /**
   * Whether it is that of the scene.
   */
  is_own: boolean;
}
/**
 * A file as the program writes it.
 */
export interface FileRequest {
  /**
   * What kind of file.
   */
  format: Format;
  /**
   * What is drawn.
   */
  of: Subject;
}
/**
 * What can be drawn over the cycle.
 */
export interface Curves {
  /**
   * The sheet.
   */
  svg: string;
  /**
   * Width of the sheet in mm.
   */
  width: number;
  /**
   * Height of the sheet in mm.
   */
  height: number;
  /**
   * Extreme positions, change points, limits, in words.
   */
  events: string[];
  /**
   * The axis of the drive; none where nothing is drawn over it.
   */
  axis: DriveAxis | null;
  /**
   * Ways of points and of tips of vectors, in pieces without a gap: the drive's value, x and y in mm.
   */
  ways: [number, number, number][][];
}
/**
 * Where the values of the drive are in graphs one above the other.
 */
export interface DriveAxis {
  /**
   * The value at the left edge of the graphs, in degrees or units of length.
   */
  low: number;
  /**
   * At the right edge.
   */
  high: number;
  /**
   * The graphs: [x, y, width, height] in mm.
   */
  areas: [number, number, number, number][];
}
/**
 * A value of the scene's own position.
 */
export interface Value {
  /**
   * Its name, as `v(D).size`.
   */
  name: string;
  /**
   * The quantity.
   */
  quantity: Quantity;
  /**
   * As letters with scripts: HTML of `<i>`, `<sub>`, `<sup>` and text alone.
   */
  label: string;
  /**
   * Those digits that are certain.
   */
  value: string;
  /**
   * Its unit.
   */
  unit: string;
  /**
   * How far the value can be from the true one, in the same unit; none where that is not known.
   */
  error?: string | null;
}
/**
 * What is known of a mechanism, complete or not, with its picture.
 */
export interface Drafted {
  /**
   * The picture.
   */
  svg: string;
  /**
   * Width of the picture in mm.
   */
  width: number;
  /**
   * Height of the picture in mm.
   */
  height: number;
  /**
   * The points whose places are known.
   */
  points: DraftedPoint[];
  /**
   * The sliders, in the order of the scene.
   */
  sliders: DraftedSlider[];
  /**
   * Whether the mechanism is complete: it has a position.
   */
  is_complete: boolean;
}
/**
 * A point of it.
 */
export interface DraftedPoint {
  /**
   * Its name.
   */
  name: string;
  /**
   * Its place, in units of length.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * Whether it is a point of the ground.
   */
  is_fixed: boolean;
}
/**
 * A slider of it.
 */
export interface DraftedSlider {
  /**
   * The unit direction of its guide; none where that is not known.
   *
   * @minItems 2
   * @maxItems 2
   */
  along: [number, number] | null;
  /**
   * How far it is along its guide now, in units of length; none where that is not known.
   */
  position: number | null;
}
/**
 * What of the mechanism is seen.
 */
export interface DraftedView {
  /**
   * The part of the screen.
   */
  pane: Pane;
  /**
   * The place of the mechanism in its middle, in units of length.
   *
   * @minItems 2
   * @maxItems 2
   */
  centre: [number, number];
  /**
   * Pixels for a unit of length.
   */
  scale: number;
}
/**
 * A drawing on a board.
 */
export interface Board {
  /**
   * The drawing's text; of no text that of an empty drawing.
   */
  drawing: string;
  /**
   * What the scene gives.
   */
  given: BoardNumber[];
  /**
   * The sheets.
   */
  sheets: BoardSheet[];
  /**
   * All that can be pointed at.
   */
  things: BoardThing[];
  /**
   * What a formula may use: what is given, what has been found, what may be measured.
   */
  numbers: BoardNumber[];
  /**
   * The names that mean something, in the order of the construction.
   */
  names: BoardName[];
  /**
   * The next free names of one's own.
   */
  free: FreeNames;
  /**
   * What is said of the hand where it is free: how near it has to be; none where what it draws is exact.
   */
  hand: string | null;
  /**
   * The entries of the drawing, in order.
   */
  did: BoardEntry[];
  /**
   * The first entry that cannot be carried out; none where all can.
   */
  refused: BoardRefused | null;
}
/**
 * A number beside the sheets.
 */
export interface BoardNumber {
  /**
   * Its name in formulas.
   */
  name: string;
  /**
   * As the sheets write it, in HTML.
   */
  label: string;
  /**
   * Its value in figures.
   */
  value: string;
  /**
   * Its unit.
   */
  unit: string;
  /**
   * The entry that made it; none for what is given or can be measured.
   */
  entry: number | null;
}
/**
 * A sheet of a board.
 */
export interface BoardSheet {
  /**
   * Which sheet.
   */
  sheet: Panel;
  /**
   * Width in mm.
   */
  width: number;
  /**
   * Height in mm.
   */
  height: number;
  /**
   * Where the pole stands; none on the scheme.
   *
   * @minItems 2
   * @maxItems 2
   */
  pole: [number, number] | null;
  /**
   * Its scale in words.
   */
  scale: string;
}
/**
 * Something that can be pointed at.
 */
export interface BoardThing {
  /**
   * On which sheet.
   */
  sheet: Panel;
  /**
   * What it is.
   */
  kind: ThingKind;
  /**
   * Its name, as entries call it.
   */
  name: string;
  /**
   * As the sheet writes it, in HTML.
   */
  label: string;
  /**
   * It in words, as `link 2`.
   */
  words: string;
  /**
   * Its outline, as the path of an SVG; empty for a point.
   */
  path: string;
  /**
   * A place of it.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * The entry that made it; none for what is given.
   */
  entry: number | null;
}
/**
 * A name that means something.
 */
export interface BoardName {
  /**
   * On which sheet; none of a number.
   */
  sheet: Panel | null;
  /**
   * Of a point or of a number.
   */
  kind: NameKind;
  /**
   * The name.
   */
  name: string;
  /**
   * As the sheets write it, in HTML.
   */
  label: string;
  /**
   * Whether it is there already.
   */
  is_made: boolean;
  /**
   * Whether it is the rate of a link, which turns in one sense or the other.
   */
  is_turning: boolean;
}
/**
 * Names of one's own that are free.
 */
export interface FreeNames {
  /**
   * For a line.
   */
  line: string;
  /**
   * For an auxiliary point.
   */
  point: string;
  /**
   * For a number.
   */
  number: string;
}
/**
 * An entry on a board.
 */
export interface BoardEntry {
  /**
   * What it does, with what came out.
   */
  words: string;
  /**
   * On which sheet; none for a computation.
   */
  sheet: Panel | null;
  /**
   * Whether it has not been taken back.
   */
  stands: boolean;
  /**
   * The entries whose results it uses.
   */
  needs: number[];
}
/**
 * An entry that cannot be carried out.
 */
export interface BoardRefused {
  /**
   * Its index.
   */
  entry: number;
  /**
   * Why.
   */
  message: string;
}
/**
 * A press on a sheet.
 */
export interface Pressed {
  /**
   * The entry that is being written, with what is missing left out or empty.
   */
  has: unknown;
  /**
   * On which sheet.
   */
  sheet: Panel;
  /**
   * Where, in mm from the upper left corner, y down.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * How far around, in mm.
   */
  reach: number;
}
/**
 * What a press may mean.
 */
export interface Snapped {
  /**
   * The entry with what the press adds.
   */
  entry: unknown;
  /**
   * Whether no more than a name may be missing.
   */
  is_whole: boolean;
  /**
   * What is caught, in words.
   */
  words: string;
  /**
   * Where.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * What would be drawn.
   */
  ghost: Ghost[];
  /**
   * The direction that it gives, in degrees from +x; none of what gives none.
   */
  direction: number | null;
}
/**
 * Something that is not drawn yet.
 */
export interface Ghost {
  /**
   * What it is.
   */
  kind: GhostKind;
  /**
   * Its outline, as the path of an SVG in mm.
   */
  path: string;
}
/**
 * A sheet of paper.
 */
export interface SheetPicture {
  /**
   * The picture; one unit of it is a millimetre of the sheet.
   */
  svg: string;
  /**
   * Width in mm.
   */
  width: number;
  /**
   * Height in mm.
   */
  height: number;
}
/**
 * Which picture of a drawing is wanted.
 */
export interface BoardPictureAsk {
  /**
   * Of which sheet.
   */
  sheet: Panel;
  /**
   * How many entries are shown; none for all.
   */
  until: number | null;
  /**
   * Height of the letters in mm; none for those of a sheet of paper.
   */
  letters: number | null;
  /**
   * Whether what is wrong is marked.
   */
  judged: boolean;
}
/**
 * What is found of a drawing.
 */
export interface BoardJudged {
  /**
   * The entries with their verdicts.
   */
  entries: JudgedEntry[];
  /**
   * The index of the first wrong one; none where nothing is wrong.
   */
  first_wrong: number | null;
  /**
   * Whether all that the scene asks for is there and nothing is wrong.
   */
  is_complete: boolean;
  /**
   * What it asks for and is not there.
   */
  missing: string[];
}
/**
 * An entry with its verdict.
 */
export interface JudgedEntry {
  /**
   * Its index in the drawing, from 0.
   */
  index: number;
  /**
   * What it does, in words.
   */
  does: string;
  /**
   * What is found of it.
   */
  verdict: DrawingVerdict;
  /**
   * What is wrong.
   */
  says?: string | null;
  /**
   * The mistake of the catalogue.
   */
  mistake?: string | null;
  /**
   * What was probably done.
   */
  done?: string | null;
  /**
   * What it should be.
   */
  should?: string | null;
}
/**
 * A hint.
 */
export interface BoardHint {
  /**
   * What is said.
   */
  words: string;
  /**
   * The sheet that it is about; none for a computation, and where nothing is left to do.
   */
  sheet: Panel | null;
  /**
   * What would be drawn, from the third stage on.
   */
  ghost: Ghost[];
  /**
   * The index of the entry that is wrong; none where the hint is about the next one.
   */
  entry: number | null;
}
/**
 * The form of a scene.
 */
export interface Form {
  /**
   * Its boxes in the order of the construction; behind them those of further values that a filled form has.
   */
  rows: FormRow[];
  /**
   * By sheet: its scale, in units per mm of paper.
   */
  scales: {
    [k: string]: number | null;
  };
  /**
   * By plan: the pole and the points whose places can be given, by the names of the form file.
   */
  points: {
    [k: string]: PlanPoint[];
  };
  /**
   * The empty form, as `kinegon check --template` writes it.
   */
  json: string;
  /**
   * The same as a table.
   */
  csv: string;
}
/**
 * A box of the form of measured values.
 */
export interface FormRow {
  /**
   * The name under which its value stands in the form file.
   */
  name: string;
  /**
   * As the sheet writes it: HTML of `<i>`, `<sub>`, `<sup>` and text alone.
   */
  label: string;
  /**
   * The velocity or acceleration that a segment of a plan is, in the same HTML; empty for what is none.
   */
  vector: string;
  /**
   * The scene's unit of it.
   */
  unit: string;
  /**
   * The sheet from which it is read.
   */
  panel: Panel;
  /**
   * The step that gives it.
   */
  step: number;
  /**
   * That step's caption.
   */
  caption: string;
  /**
   * Whether it has a sense, which a sign tells.
   */
  has_sense: boolean;
  /**
   * Whether that sense is one of rotation.
   */
  turns: boolean;
  /**
   * Whether it can be given in millimetres of paper, with `/mu` behind its name.
   */
  on_paper: boolean;
  /**
   * Whether it is a length of the scheme or a segment of a plan, which `"in": "mm"` makes millimetres of paper.
   */
  is_segment: boolean;
  /**
   * Whether the empty form asks for it.
   */
  is_asked: boolean;
}
/**
 * A point of a plan.
 */
export interface PlanPoint {
  /**
   * The name under which its place stands in the form file.
   */
  name: string;
  /**
   * As the sheet writes it, in HTML.
   */
  label: string;
}
/**
 * A form that was checked.
 */
export interface Checked {
  /**
   * As `kinegon check --json`; none where no value is understood.
   */
  result: CheckResult | null;
  /**
   * As `kinegon check`.
   */
  report: string;
  /**
   * The report piece by piece; all texts but names are HTML of `<sub>`, `<sup>` and text alone.
   */
  parts: ReportParts | null;
  /**
   * Values that are not understood, by their names in the form.
   */
  faults: Fault[];
  /**
   * The student's drawing over the right one, where it was asked for.
   */
  overlays: SheetPicture[];
  /**
   * The page that `--feedback` writes for a browser, where it was asked for.
   */
  feedback: string;
  /**
   * The marks in words, where a marking scheme was given.
   */
  marks: string | null;
}
/**
 * Verdicts and diagnosis of one drawing.
 */
export interface CheckResult {
  /**
   * Version of the format.
   */
  kinegon_check: number;
  /**
   * Whose drawing it is.
   */
  name?: string | null;
  /**
   * Whether all that the scene asks for is there and right: nothing off, missing, without a sense or without information, no plan mirrored.
   */
  passed: boolean;
  /**
   * The values in the order of the construction.
   */
  values: ValueResult[];
  /**
   * What explains them best.
   */
  diagnosis: ExplanationResult;
  /**
   * What explains them, too.
   */
  others: ExplanationResult[];
  /**
   * Values that nothing explains.
   */
  unexplained: string[];
  /**
   * How accurate the drawing is, as the scatter of all values shows; not there where too few values are drawn.
   */
  accuracy?: AccuracyResult | null;
  /**
   * Plans whose places on paper are the mirror image of the right ones: "velocity", "acceleration".
   */
  mirrored?: string[];
  /**
   * Plans whose places on paper lie turned to the scheme, with all of the sheet; directions are judged without that.
   */
  turned?: TurnedResult[];
  /**
   * What the scene asks for, by its `form` or else by all its steps, and the form has no value of.
   */
  missing?: string[];
  /**
   * The exercise of the class whose values these are, where they are those of another one.
   */
  values_of?: string | null;
  /**
   * Scales of the form that are not those asked for, or at which no sheet can be drawn.
   */
  scales?: ScaleResult[];
  /**
   * An error that all measured lengths have in common, taken out of the values: `{ "scale": 0.031 }` where they are 3.1 % too
   * large, `{ "zero": 2 }` where they are 2 mm too long.
   */
  common?: CommonErrorResult | null;
  /**
   * How many stages of hints the student opened in the workbench.
   */
  hints?: number | null;
  /**
   * The marks that the values earn, where a marking scheme is given.
   */
  marks?: Awarded | null;
}
/**
 * A value with its verdict.
 */
export interface ValueResult {
  /**
   * The quantity's name.
   */
  quantity: string;
  /**
   * The number of the step that gives it.
   */
  step: number;
  /**
   * The value in the scene's units and senses.
   */
  value: number;
  /**
   * The exact value.
   */
  expected: number;
  /**
   * Unit of both.
   */
  unit: string;
  /**
   * The value less the exact one.
   */
  difference: number;
  /**
   * The same in millimetres of paper.
   */
  difference_mm?: number | null;
  /**
   * The same in per cent of the exact value.
   */
  percent?: number | null;
  /**
   * Largest difference that is within the tolerance; left out where the scene gives the value.
   */
  allowed?: number | null;
  /**
   * Whether that is a coarse tolerance, as no construction by hand gives the value.
   */
  coarse?: boolean;
  /**
   * "right", "within-tolerance", "sense-missing" (the size is right, the sense is not told), "off", "too-coarse" (its digits tell nothing)
   * or "unjudged" (it is too small on its sheet).
   */
  verdict: string;
}
/**
 * Mistakes that explain the values together.
 */
export interface ExplanationResult {
  /**
   * The mistakes in the order of the construction.
   */
  mistakes: MistakeResult[];
  /**
   * The probability that these were made, or others that the values alone cannot tell from them, from 0 to 1; an
   * honest share is left for mistakes that the catalogue does not have. Causes are told from 0.6 on. Without mistakes:
   * the probability that none was made that the catalogue has.
   */
  probability: number;
  /**
   * Whether the given values alone cannot tell it from the diagnosis.
   */
  indistinguishable?: boolean;
  /**
   * Whether it is one way in which what the diagnosis tells as "unknown", only by its place, may have happened: its probability is a part
   * of the diagnosis's.
   */
  within?: boolean;
}
/**
 * A mistake that was probably made.
 */
export interface MistakeResult {
  /**
   * Its name in the catalogue.
   */
  mistake: string;
  /**
   * The number of its step; 0 for the whole drawing.
   */
  step: number;
  /**
   * What was probably done.
   */
  done: string;
  /**
   * What it should be.
   */
  should_be: string;
  /**
   * Values written otherwise than meant.
   */
  written?: string[];
  /**
   * Values that follow from it and are consistent with it.
   */
  follows: string[];
}
/**
 * How accurate somebody draws and computes. Within the limits every error is equally likely.
 */
export interface AccuracyResult {
  /**
   * Limit of the errors in lengths and places, in mm of paper.
   */
  mm: number;
  /**
   * Limit of the errors in directions, in degrees.
   */
  degrees: number;
  /**
   * Limit of the errors of computed numbers, in per cent; 0 where no slips are seen.
   */
  percent: number;
}
/**
 * A plan that lies turned to the scheme.
 */
export interface TurnedResult {
  /**
   * The plan: "velocity", "acceleration".
   */
  plan: string;
  /**
   * By how many degrees, positive counter-clockwise.
   */
  degrees: number;
}
/**
 * A scale of a form that is not the one asked for, or at which no sheet can be drawn.
 */
export interface ScaleResult {
  /**
   * Its name in the form: `mu_l`, `mu_v`, `mu_a`.
   */
  scale: string;
  /**
   * What the form states, in units per millimetre.
   */
  stated: number;
  /**
   * What the scene's figure states.
   */
  asked?: number | null;
  /**
   * The scale by which the values are judged.
   */
  used: number;
}
/**
 * The marks that somebody's values earn.
 */
export interface Awarded {
  /**
   * Marks earned.
   */
  earned: number;
  /**
   * Marks that could be earned.
   */
  of: number;
  /**
   * Those of the earned ones that are for values which follow from an earlier mistake.
   */
  follow_through: number;
}
/**
 * A report in parts, in the markup of [`Overlay::set`](crate::drawing::Overlay::set). What is right and what was
 * probably done stand apart, so that a page can say the one without the other.
 */
export interface ReportParts {
  /**
   * How many values are right, within the tolerance, off.
   */
  counts: string;
  /**
   * What is asked for and not there.
   */
  missing: string | null;
  /**
   * What else the verdict does not rest on: values that tell nothing, and scales that are not those asked for.
   */
  rests_on: string[];
  /**
   * How much is allowed, and how accurate the drawing is.
   */
  accuracy: string[];
  /**
   * Headings of the cells of a value.
   *
   * @minItems 8
   * @maxItems 8
   */
  columns: [string, string, string, string, string, string, string, string];
  /**
   * The values in the order of the construction.
   */
  rows: ReportRow[];
  /**
   * About rates without a sense, if there are any.
   */
  senses: string | null;
  /**
   * The heading of the mistakes, or the sentence that there are none, or that none can be told.
   */
  heading: string;
  /**
   * The mistakes that were probably made.
   */
  causes: Cause[];
  /**
   * How many stages of a hint a student may open, of those of a cause and of all that it tells.
   */
  hints: number;
  /**
   * How sure these are.
   */
  sure: string | null;
  /**
   * Which values nothing explains, and which plans are mirrored.
   */
  further: string[];
  /**
   * The heading of these.
   */
  others_heading: string;
  /**
   * What else explains the values, or what may have been done where only the place of a mistake is told.
   */
  others: string[];
}
/**
 * A value of a report.
 */
export interface ReportRow {
  /**
   * The name of the form's box.
   */
  name: string;
  /**
   * Name, own value, exact value, difference, the same on paper and in per cent, what is allowed, verdict.
   *
   * @minItems 8
   * @maxItems 8
   */
  cells: [string, string, string, string, string, string, string, string];
}
/**
 * A mistake that was probably made.
 */
export interface Cause {
  /**
   * At which step, and what was done.
   */
  done: string;
  /**
   * The step's caption.
   */
  caption: string | null;
  /**
   * What it should be.
   */
  should: string;
  /**
   * Which values follow from it.
   */
  follows: string | null;
  /**
   * The step worked out with the student's own numbers; by how much what was drawn is off.
   */
  worked: string[];
  /**
   * Which steps are to be done again.
   */
  redo: string | null;
  /**
   * The stages of a hint before all this is told: the plan, the first wrong value, the step.
   */
  hints: string[];
  /**
   * The number of its step; 0 for the whole drawing.
   */
  step: number;
}
/**
 * A value that is not understood.
 */
export interface Fault {
  /**
   * Its name as the form has it.
   */
  name: string;
  /**
   * Why.
   */
  message: string;
  /**
   * What to try.
   */
  hint: string | null;
}
/**
 * How a form is checked.
 */
export interface CheckOptions {
  /**
   * Marking scheme, as for `kinegon check --marks`.
   */
  marks: string | null;
  /**
   * Tolerance of the pencil in mm; none for what the sheet shows.
   */
  pencil_mm: number | null;
  /**
   * The same in degrees.
   */
  pencil_degrees: number | null;
  /**
   * Whether the student's drawing and the page for the student are made, too.
   */
  drawn: boolean;
}
/**
 * An exercise with its files.
 */
export interface Exercise {
  /**
   * Its scene: scene.json.
   */
  text: string;
  /**
   * Its name: that of its folder.
   */
  name: string;
  /**
   * What is given and what is to be drawn, at which scales: the sheet's sentences, in HTML of `<i>`, `<sub>`, `<sup>` and text alone.
   */
  given: string[];
  /**
   * The student's sheets, as `sheet.pdf` has them: what is given, then those for the plans.
   */
  sheets: SheetPicture[];
  /**
   * The teacher's key: key.svg.
   */
  key: SheetPicture;
  /**
   * The empty form: form.json.
   */
  form: string;
  /**
   * The same as a table: form.csv.
   */
  form_csv: string;
  /**
   * The values of the key: key.json.
   */
  key_values: string;
}
/**
 * How exercises are written, as the options of `kinegon exercise`; what is not given is the scene's.
 */
export interface ExerciseOptions {
  /**
   * The sheet, as `a4-landscape`; none for A4, or A3 where few variants can be drawn well on A4.
   */
  page: string | null;
  /**
   * Language, as `es`.
   */
  language: string | null;
  /**
   * Notation.
   */
  notation: string | null;
  /**
   * Decimal mark.
   */
  decimal: string | null;
}
/**
 * What is read from a photograph: one of both.
 */
export interface PhotoRead {
  /**
   * The sheet in it.
   */
  photo: Photo | null;
  /**
   * Why none is read.
   */
  refused: PhotoRefused | null;
}
/**
 * A sheet in a photograph. Places in the picture are in pixels from its upper left corner, y down, after `turn`.
 */
export interface Photo {
  /**
   * The exercise or scene that the sheet is of, as its code has it.
   */
  name: string;
  /**
   * The sheet's number.
   */
  number: number;
  /**
   * Whether it is a sheet of this scene.
   */
  is_own: boolean;
  /**
   * By how many quarters the picture is turned clockwise, so that the sheet stands upright.
   */
  turn: number;
  /**
   * Pixels per mm in the sheet's middle.
   */
  per_mm: number;
  /**
   * How far the sheet's middle is above or below its edges, in mm.
   */
  bend: number;
  /**
   * What makes it of less use, and what to do; none where nothing does.
   */
  warning: string | null;
  /**
   * Radius within which places on the sheet are known with 95 %, at the plans' points, in mm.
   */
  band: number;
  /**
   * The plans on it; none of another scene's sheet.
   */
  plans: PhotoPlan[];
}
/**
 * The right plan over a photograph.
 */
export interface PhotoPlan {
  /**
   * Of which plan.
   */
  plan: Panel;
  /**
   * The sheet's scale, in units per mm.
   */
  mu: number;
  /**
   * Its points in the order of the construction, the pole first.
   */
  points: PhotoPoint[];
  /**
   * Its vectors and rays: places along each in the picture.
   */
  lines: [number, number][][];
}
/**
 * A point of the right plan in the picture.
 */
export interface PhotoPoint {
  /**
   * The name under which its place stands in the form file.
   */
  name: string;
  /**
   * As the sheet writes it, in HTML.
   */
  label: string;
  /**
   * Where it should be in the picture.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
}
/**
 * Why no sheet is read from a photograph.
 */
export interface PhotoRefused {
  /**
   * What is wrong.
   */
  message: string;
  /**
   * What to do.
   */
  hint: string;
}
/**
 * A place that was tapped, or is proposed.
 */
export interface Tapped {
  /**
   * In mm of paper from the printed origin, x right, y up.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * In the picture.
   *
   * @minItems 2
   * @maxItems 2
   */
  pixel: [number, number];
  /**
   * Whether pencil lines cross there.
   */
  is_snapped: boolean;
  /**
   * Radius that holds the place with 95 %, in mm.
   */
  band: number;
  /**
   * The same in pixels.
   */
  band_pixels: number;
}
/**
 * A point of a student's plan.
 */
export interface MarkedPoint {
  /**
   * Of which plan.
   */
  plan: Panel;
  /**
   * Its name in the form file.
   */
  name: string;
  /**
   * In mm of paper from the printed origin, x right, y up.
   *
   * @minItems 2
   * @maxItems 2
   */
  at: [number, number];
  /**
   * Radius that holds it with 95 %, in mm; none where a hand has put it.
   */
  band: number | null;
}
/**
 * How a point of a student's plan stands.
 */
export interface PointVerdict {
  /**
   * Of which plan.
   */
  plan: Panel;
  /**
   * Its name in the form file.
   */
  name: string;
  /**
   * Where it is in the picture.
   *
   * @minItems 2
   * @maxItems 2
   */
  pixel: [number, number];
  /**
   * Radius that holds it with 95 %, in pixels.
   */
  band_pixels: number;
  /**
   * How far it is from the right place, in mm.
   */
  off: number;
  /**
   * What its place tells; `open`: the picture cannot tell.
   */
  verdict: PlaceVerdict;
}
/**
 * A point that pencil lines show: a proposal, as lines may mislead.
 */
export interface Proposed {
  /**
   * Of which plan.
   */
  plan: Panel;
  /**
   * Its name in the form file.
   */
  name: string;
  /**
   * Where it seems to be.
   */
  place: Tapped;
}
/**
 * A planar mechanism: x right, y up, counter-clockwise positive, angles in degrees.
 */
export interface SceneFile {
  /**
   * Version of the scene format.
   */
  kinegon: 1;
  /**
   * Title of the mechanism, for example the publication it is from.
   */
  title?: string;
  /**
   * Units of every length and time of the scene. They are labels; nothing is converted.
   */
  units: SceneUnits;
  /**
   * The frame's points with their coordinates; in a drawn configuration their names are enough.
   */
  ground?: SceneGround;
  /**
   * A drawn configuration: coordinates of every point. Then there are no lengths, shapes or angles.
   */
  points?: {
    [k: string]: SceneVector;
  };
  /**
   * Points of known motion, in a drawn configuration.
   */
  known?: {
    [k: string]: ScenePointMotion;
  };
  /**
   * The links by name. A point named in two links is a revolute joint between them.
   */
  links: {
    [k: string]: SceneLink;
  };
  /**
   * Links that slide along straight guides, and pins that ride in slots.
   */
  sliders?: SceneSlider[];
  /**
   * Pairs of wheels that mesh.
   */
  gears?: SceneGear[];
  /**
   * Profiles that touch, as those of a cam and its follower.
   */
  contacts?: SceneContact[];
  /**
   * The acceleration of free fall, in length per time²; left out: zero.
   */
  gravity?: SceneVector;
  /**
   * Forces and couples on links.
   */
  forces?: SceneLoad[];
  /**
   * Springs between links.
   */
  springs?: SceneSpring[];
  /**
   * Coulomb friction in joints, which counts where loads press on them.
   */
  friction?: SceneFriction[];
  /**
   * Whether inertia counts among the loads; left out: dynamic.
   */
  analysis?: SceneAnalysis;
  /**
   * Approximate coordinates of some points, and angles of links as "angle(3)", to choose the assembly mode.
   * The one with the least sum of squared distances from them is taken; an angle counts as its chord at a radius of the mechanism's size.
   * A slotted lever with one point has its slider on the positive side of `through`, unless its angle stands here.
   */
  near?: {
    [k: string]: SceneNearValue;
  };
  /**
   * What the figure shows, and how large.
   */
  figure?: SceneFigure;
  /**
   * Names of the quantities asked for, as "omega(2)" or "a(S3)"; left out: everything.
   */
  want?: string[];
  /**
   * The quantities for which the forms and sheets of students have boxes, as "omega(2)" or "vplan(p,b)", with the marks that each is
   * worth; left out: all that the steps of the construction give, one mark each. What no step gives has no box.
   */
  form?: {
    [k: string]: number;
  };
  /**
   * How many stages of a hint somebody may open who solves this as an exercise in the workbench: 1 the plan, 2 the first wrong value,
   * 3 the step, 4 what was done; left out: all.
   */
  hints?: number;
  /**
   * Where an editor finds this schema; ignored
   */
  $schema?: string;
}
/**
 * Units of every length and time of the scene, and of masses and forces where it has some.
 */
export interface SceneUnits {
  /**
   * Unit of length.
   */
  length: SceneLengthUnit;
  /**
   * Unit of time.
   */
  time: SceneTimeUnit;
  /**
   * Unit of mass, where links have masses.
   */
  mass?: SceneMassUnit;
  /**
   * Unit of force, where there are masses, forces or springs.
   */
  force?: SceneForceUnit;
}
/**
 * A vector by size and angle.
 */
export interface SceneSizeAngle {
  /**
   * Size, not negative.
   */
  size: number;
  /**
   * Angle from +x, in degrees.
   */
  angle: number;
}
/**
 * Known motion of a point.
 */
export interface ScenePointMotion {
  /**
   * Velocity, in length per time.
   */
  velocity: SceneVector;
  /**
   * Acceleration, in length per time squared; left out: zero.
   */
  acceleration?: SceneVector;
}
/**
 * A rigid link. Its axis runs from its first to its second point.
 */
export interface SceneLinkFields {
  /**
   * Names of its points.
   */
  points?: string[];
  /**
   * Distances between its points, as { "AB": 100 } or { "A-B": 100 }: one for two points, three for three.
   */
  lengths?: {
    [k: string]: number;
  };
  /**
   * Coordinates of its points in its own frame, whose x axis is the link's axis.
   */
  shape?: {
    [k: string]: SceneShapePoint;
  };
  /**
   * The drive that turns the link about its ground pivot.
   */
  drive?: SceneLinkDrive;
  /**
   * Angle of the link's axis from +x in degrees, in place of that of a drive: one link may give it where one drive does not.
   */
  angle?: number;
  /**
   * Known motion of the link, in a drawn configuration.
   */
  motion?: SceneLinkMotion;
  /**
   * Its mass, in the scene's unit of mass.
   */
  mass?: number;
  /**
   * Its weight, in the scene's unit of force, in place of its mass.
   */
  weight?: number;
  /**
   * Its moment of inertia about the centre of mass, in mass · length²; left out: zero.
   */
  inertia?: number;
  /**
   * Its centre of mass: a point, coordinates in the link's own frame (in a drawn configuration in the fixed frame), or a distance along its axis.
   */
  center?: SceneLinkPlace;
}
/**
 * A drive: it turns the link (angle, omega or rpm, alpha), or pushes a sliding link (position, speed, acceleration).
 */
export interface SceneLinkDrive {
  /**
   * Angle of the link's axis from +x, in degrees.
   */
  angle?: number;
  /**
   * Angular velocity, in radians per unit of time.
   */
  omega?: number;
  /**
   * Speed of rotation in turns per minute, in place of omega.
   */
  rpm?: number;
  /**
   * Angular acceleration, in radians per unit of time squared; left out: zero.
   */
  alpha?: number;
  /**
   * Of a sliding link: distance along its guide from the guide's `through`.
   */
  position?: number;
  /**
   * Of a sliding link: speed along its guide.
   */
  speed?: number;
  /**
   * Of a sliding link: acceleration along its guide; left out: zero.
   */
  acceleration?: number;
}
/**
 * Known motion of a link.
 */
export interface SceneLinkMotion {
  /**
   * The point or the place where the link has the velocity and the acceleration given here.
   */
  at: SceneNameOrPlace;
  /**
   * Velocity there, in length per time.
   */
  velocity: SceneVector;
  /**
   * Acceleration there, in length per time squared; left out: zero.
   */
  acceleration?: SceneVector;
  /**
   * Angular velocity, in radians per unit of time; left out: zero.
   */
  omega?: number;
  /**
   * Angular acceleration, in radians per unit of time squared; left out: zero.
   */
  alpha?: number;
}
/**
 * A link, by its point `at`, slides on a guide of `on`; or a pin rides in a slot of `on`.
 */
export interface SceneSlider {
  /**
   * The sliding link.
   */
  link?: string;
  /**
   * The point of the sliding link that is on the guide.
   */
  at?: string;
  /**
   * A pin of another link that rides in the slot, in place of link and at.
   */
  pin?: string;
  /**
   * What carries the guide: a link, or "ground".
   */
  on: string;
  /**
   * A place on the guide: a point of `on`, or [x, y] on the ground or in the shape of `on`.
   * Left out: the first point of `along`, else of `on`.
   */
  through?: SceneNameOrPlace;
  /**
   * The direction of the guide; left out: 0.
   * Degrees count from +x on the ground, from the axis of `on` otherwise.
   */
  along?: SceneDirection;
  /**
   * Degrees from the guide to the slider's axis; left out: 0.
   */
  turned?: number;
  /**
   * The least and the greatest position along the guide at which the guide still holds what slides: the ends of a slot. Not in a drawn
   * configuration.
   *
   * @minItems 2
   * @maxItems 2
   */
  travel?: [number, number];
  /**
   * The drive that pushes the slider.
   */
  drive?: SceneSliderDrive;
}
/**
 * A drive that pushes a slider along its guide.
 */
export interface SceneSliderDrive {
  /**
   * Distance along the guide from `through`.
   */
  position?: number;
  /**
   * Speed along the guide.
   */
  speed: number;
  /**
   * Acceleration along the guide; left out: zero.
   */
  acceleration?: number;
}
/**
 * Two wheels that mesh: their pitch circles roll on each other without slip; or a wheel that rolls on a rack; or two wheels with a belt.
 */
export interface SceneGear {
  /**
   * The two wheels: links, or "ground" for a wheel that is fixed to the frame.
   *
   * @minItems 2
   * @maxItems 2
   */
  mesh: [string, string];
  /**
   * Their numbers of teeth, in the same order; that of a ring with inner teeth is negative. Wheels that only roll, and those of belts, have
   * whole numbers in the ratio of their radii. "rack" stands for a straight rack, which slides on the carrier, or on which the carrier slides.
   *
   * @minItems 2
   * @maxItems 2
   */
  teeth: [SceneTeeth, SceneTeeth];
  /**
   * The carrier on whose pins both turn: a link (the arm of a planetary train), or "ground".
   */
  on: string;
  /**
   * How a belt or a chain runs around the wheels, in place of teeth that mesh.
   */
  belt?: SceneBelt;
  /**
   * The radius of the wheel's pitch circle on a rack; of wheels with a belt that of the first, which is only drawn.
   */
  radius?: number;
  /**
   * The rack's position along its guide, or the carrier's along the rack, where the wheel's axis stands at 0 from the carrier's; left out: 0.
   * Not in a drawn configuration.
   */
  position?: number;
  /**
   * The angle of the second wheel's axis when that of the first stands at 0, both from the carrier's axis, in degrees; left out: 0.
   * Not in a drawn configuration.
   */
  phase?: number;
  /**
   * The pressure angle in degrees, with which the teeth push each other apart; left out: 0, only the tangential force counts.
   */
  pressure?: number;
}
/**
 * Two profiles that touch, as those of a cam and its follower.
 */
export interface SceneContact {
  /**
   * The two bodies that touch: links, or "ground".
   *
   * @minItems 2
   * @maxItems 2
   */
  links: [string, string];
  /**
   * The centres of curvature of their profiles at the contact, a point of each, in the same order; only that of the first where the second
   * profile is flat.
   *
   * @minItems 1
   * @maxItems 2
   */
  centers: [string] | [string, string];
  /**
   * The radii of curvature in the same order, that of a hollow profile negative. In a drawn configuration they may be left out.
   *
   * @minItems 1
   * @maxItems 2
   */
  radii?: [number] | [number, number];
  /**
   * The direction of the flat profile of the second body, as that of a guide; the first body lies to its right, below a face that runs to +x.
   */
  along?: SceneDirection;
  /**
   * A place on the flat profile: a point of the second body, or [x, y] on the ground or in its shape.
   * Left out: the first point of `along`, else of the body.
   */
  through?: SceneNameOrPlace;
  /**
   * Whether the second body touches with a roller about its centre; left out: false.
   */
  roller?: boolean;
  /**
   * Whether both profiles are circles about these centres, or a circle and a straight line, so that the linkage is equivalent in every position;
   * left out: false, in this position alone.
   */
  circular?: boolean;
  /**
   * The name of the equivalent link; left out: E1, E2 … in the order of the contacts.
   */
  name?: string;
}
/**
 * A force or a couple on a link, in the file.
 */
export interface SceneLoad {
  /**
   * Its name in tables and figures; left out: F1, F2 … for forces; M1 for a couple on link 1, M2 for one on link 2 ….
   */
  name?: string;
  /**
   * The link on which it acts.
   */
  on: string;
  /**
   * Where the force acts.
   */
  at?: SceneLinkPlace;
  /**
   * The force, in the scene's unit of force.
   */
  force?: SceneVector;
  /**
   * The couple, in force · length, counter-clockwise positive.
   */
  couple?: number;
  /**
   * Whether the force turns with the link: then its components are along the link's axis and normal to it.
   */
  turns?: boolean;
  /**
   * How often the force and the couple act over the motion; left out: once everywhere.
   */
  over?: SceneOver;
}
/**
 * How a load changes over the motion, in the file.
 */
export interface SceneOver {
  /**
   * What it depends on: `angle(1)`, the angle of a link, or `position(3/ground)`, the position of a slider.
   */
  of: string;
  /**
   * Pairs: an angle in degrees or a position, and how many times the given force and couple act there; or a file with them.
   */
  table: SceneLoadTable;
}
/**
 * A spring between two places, in the file.
 */
export interface SceneSpring {
  /**
   * Its name in tables and figures; left out: K1, K2 …
   */
  name?: string;
  /**
   * Its two ends, each a link or "ground" and a place of it.
   */
  between: SceneSpringEnd[];
  /**
   * Force per length of extension.
   */
  rate: number;
  /**
   * Its length without a force.
   */
  length: number;
}
/**
 * Friction in the joints at a pin or in a guide, in the file.
 */
export interface SceneFriction {
  /**
   * The point of a pin.
   */
  pin?: string;
  /**
   * The name of a slider, as "3/ground" or "P/3".
   */
  guide?: string;
  /**
   * The coefficient of friction.
   */
  coefficient?: number;
  /**
   * The angle of friction in degrees, in place of the coefficient.
   */
  angle?: number;
  /**
   * The radius of the pin's journal, in the scene's unit of length; of a pin alone.
   */
  radius?: number;
  /**
   * The link in which the pin is fixed, or "ground"; of a pin through three or more links, which all turn on it, alone.
   */
  fixed_in?: string;
}
/**
 * What the figure shows, and how large.
 */
export interface SceneFigure {
  /**
   * The panels, in order; left out: the scheme and both plans.
   *
   * @minItems 1
   */
  panels?: [ScenePanel, ...ScenePanel[]];
  /**
   * Scale of the scheme: units of length per millimetre of paper.
   */
  mu_l?: number;
  /**
   * Scale of the velocity plan: units of velocity per millimetre of paper.
   */
  mu_v?: number;
  /**
   * Scale of the acceleration plan: units of acceleration per millimetre of paper.
   */
  mu_a?: number;
  /**
   * Scale of the figure of instant centres: units of length per millimetre of paper.
   */
  mu_c?: number;
  /**
   * Scale of the force plan: units of force per millimetre of paper.
   */
  mu_f?: number;
  /**
   * Scale of the lever: units of velocity per millimetre of paper.
   */
  mu_h?: number;
  /**
   * Scale of the speed diagram: units of length per millimetre of paper.
   */
  mu_k?: number;
  /**
   * For which plans scales are chosen that are not given; left out: "position".
   */
  scales?: SceneScalesFor;
  /**
   * The panel that takes most of the sheet; a plan has the scheme as a small companion. Left out: the panels share the sheet.
   */
  focus?: ScenePanel;
  /**
   * The sheet: "a4", "a3", "letter" or, for the projector, "16x9", with "-portrait" where it does not lie; left out: "a4".
   */
  page?:
    | "a4"
    | "a4-landscape"
    | "a4-portrait"
    | "a3"
    | "a3-landscape"
    | "a3-portrait"
    | "letter"
    | "letter-landscape"
    | "letter-portrait"
    | "16x9"
    | "16x9-landscape"
    | "16x9-portrait";
  /**
   * Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false.
   */
  worksheet?: boolean;
  /**
   * Whether Willis' table of the trains of wheels stands beside the panels; not on a work sheet. Left out: false.
   */
  willis?: boolean;
  /**
   * How lines and letters look; left out: "paper".
   */
  style?: SceneStyleName;
  /**
   * How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same.
   */
  notation?: SceneNotation;
  /**
   * How motions along guides are written: "slider" as v_r(3/2), "points" as v_B3B2; left out: "slider".
   */
  sliding?: SceneSliding;
  /**
   * The index of Coriolis accelerations; left out: that of the notation.
   */
  coriolis?: SceneCoriolis;
  /**
   * How instant centres are written: P_13, I_13 or CIR_13; left out: "P".
   */
  center_letter?: SceneCenter;
  /**
   * The number that the frame is called by, unless `labels` has a text for `ground`; left out: a word.
   */
  frame?: SceneFrame;
  /**
   * The sense in which figures and steps show the velocity plan turned by 90°; sheets to be drawn on, keys and checks have it as
   * it is. Left out: not turned.
   */
  turned?: SceneTurned;
  /**
   * Language of headings and captions; left out: "en".
   */
  language?: SceneLanguage;
  /**
   * Decimal mark of the numbers on figures and in the text of steps; left out: "point".
   */
  decimal?: SceneDecimal;
  /**
   * Text to show in place of a name: { "B'": "B₁" }.
   */
  labels?: {
    [k: string]: string;
  };
  /**
   * Whether special points are shown; left out: true.
   */
  special_points?: boolean;
  /**
   * Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end; left out: true.
   */
  construction?: SceneConstruction;
  /**
   * Whether values stand at vectors and links, in which unit of length; left out: as the style says, "lecture" alone does.
   */
  values?: SceneValues;
  /**
   * The step of the construction up to which the figure is drawn, from 1; left out: finished.
   */
  step?: number;
  /**
   * Points of links whose paths over the whole cycle of the drive are drawn in the scheme.
   */
  trace?: string[];
  /**
   * Whether these paths go on, dashed, beyond limits of the drive, in the other assembly modes that the mechanism
   * reaches there if another link moves it; left out: false.
   */
  beyond_limits?: boolean;
  /**
   * Links whose centrodes over that cycle are drawn in the scheme: the curves of the instant centre of the link and the frame, in the frame and in the link.
   */
  centrodes?: string[];
  /**
   * Links whose inflection circles are drawn in the scheme, through instant centre and inflection pole.
   */
  inflection?: string[];
  /**
   * Number of equally spaced positions over that cycle in which the links are drawn pale; left out: none.
   */
  ghosts?: number;
  /**
   * The instant centres on the panel "centers", besides those that lead to them: "all", or a list of names, as ["P(2,ground)"]. Left out: all of a
   * mechanism with at most four links, of a larger one those of all links with the frame.
   */
  centers?: SceneCenters;
  /**
   * Points of links whose velocities that panel shows, found by centres from the one drive.
   */
  velocities?: string[];
  /**
   * Points of links for whose paths that panel shows the centres of curvature, by Bobillier's construction.
   */
  curvature?: string[];
  /**
   * Whether sheets to be drawn on, work sheets and those of exercises, have markers along their edges by which a
   * photograph of them is read; left out: true.
   */
  markers?: boolean;
}

/**
 * The sheets in the order in which they are drawn: their words, the keys of their scales, the letters of their vectors.
 */
export const SHEETS = [
  {
    "key": "scheme",
    "scale": "mu_l",
    "isPlan": false,
    "hasPlaces": false,
    "isUsual": true,
    "vector": ""
  },
  {
    "key": "velocity",
    "scale": "mu_v",
    "isPlan": true,
    "hasPlaces": true,
    "isUsual": true,
    "vector": "v"
  },
  {
    "key": "acceleration",
    "scale": "mu_a",
    "isPlan": true,
    "hasPlaces": true,
    "isUsual": true,
    "vector": "a"
  },
  {
    "key": "centers",
    "scale": "mu_c",
    "isPlan": false,
    "hasPlaces": true,
    "isUsual": false,
    "vector": ""
  },
  {
    "key": "forces",
    "scale": "mu_f",
    "isPlan": false,
    "hasPlaces": false,
    "isUsual": false,
    "vector": ""
  },
  {
    "key": "lever",
    "scale": "mu_h",
    "isPlan": false,
    "hasPlaces": false,
    "isUsual": false,
    "vector": ""
  },
  {
    "key": "speeds",
    "scale": "mu_k",
    "isPlan": false,
    "hasPlaces": false,
    "isUsual": false,
    "vector": ""
  }
] as const;
