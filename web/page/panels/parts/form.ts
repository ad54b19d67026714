import type { Edit } from "../../engine/types.ts";
import type { Draft, Path } from "./scene.ts";

/**
 * A form as data: what can be given, not what is given. While it stays the same the fields stay and only their values change, so
 * that nobody loses the place where they type.
 */
export interface Form {
  groups: Group[];
}

export interface Group {
  id: string;
  title: string;
  help?: string;
  /** The part of the scene that it is about, for messages. */
  path?: Path;
  /** Whether it is closed at first. */
  folded?: boolean;
  rows?: Row[];
  cards?: Card[];
  /** What adds to it, beside its title. */
  adder?: Adder;
  buttons?: Button[];
}

/** A thing with a line of its own, which opens for the rest: a link, a slider. */
export interface Card {
  path: Path;
  title: string;
  name?: NameField;
  /** What it is, in a word or two. */
  role?: string;
  /** What stands in its line, with the numbers that people come for; asked for when it is seen: of a thousand links nobody sees more than some. */
  line(): Row[];
  /** What it opens for; asked for when it is open. */
  rows(): Row[];
  buttons?: Button[];
}

export interface Row {
  label?: string;
  /** Whether the label stands above its fields, as a title. */
  titled?: boolean;
  /** Whether its label is for screen readers alone. */
  quiet?: boolean;
  /** Whether its fields begin where those of the rows above and below begin. */
  aligned?: boolean;
  name?: NameField;
  path?: Path;
  fields: Field[];
  buttons?: Button[];
}

export type Field = TableField | NumberField | TextField | ChoiceField | ChecksField | SwitchField | PointsField | Adder;

/** What the owner of the form is asked to do: a name, and what with. */
export interface Ask {
  do: string;
  with: string[];
}

interface Named {
  path: Path;
  label: string;
  /** What stands in place of its label, which is then for screen readers alone: ω for the speed of a drive. */
  symbol?: string;
  /** Whether its label is for screen readers alone, because the row says it. */
  quiet?: boolean;
}

export interface NumberField extends Named {
  kind: "number";
  unit: string;
  /** Its unit, where that stands elsewhere than beside it. */
  means?: string;
  /** How far one press of an arrow key goes. */
  step: number;
  /** Whether the scene needs it; emptying any other removes the key. */
  needed?: boolean;
  /** What holds where nothing is given. */
  usual?: string;
  /** What stays while a joint is pulled in shape. */
  pin?: { point: string } | { length: string };
  /** Least value. */
  least?: number;
}

export interface TextField extends Named {
  kind: "text";
  usual?: string;
  /** Whether an empty text is one, in place of none. */
  keepsEmpty?: boolean;
}

/** A table of two columns: places and factors. */
export interface TableField extends Named {
  kind: "table";
  /** The name of its column in a file that has several. */
  load: string;
}

/** Yes or no; what is usual is not written. */
export interface SwitchField extends Named {
  kind: "switch";
  usual: boolean;
}

/** One of several values; `undefined` as the value removes the key. */
export interface ChoiceField extends Named {
  kind: "choice";
  options: Option[] | Names;
  /** Which one holds, where no one value says it. */
  now?: number;
  /** Whether all are seen at once. */
  open?: boolean;
}

/** Names of the scene's things to choose from: there may be thousands, so they are asked for as far as they are shown. */
export type Names = (scene: Draft) => Iterable<{ value: string; text: string }>;

export interface Option {
  value?: unknown;
  text: string;
  /** Any value of that form counts as this option. */
  any?: "list" | "number" | "object";
  /** Changes that it makes in place of putting its value. */
  edits?: Edit[];
  /** Or what it asks for. */
  ask?: Ask;
}

/** Points of a link, each with its name. */
export interface PointsField extends Named {
  kind: "points";
  points: { name: string; label: string; remove: string; ask: Ask }[];
}

/** Adds something that is chosen from lists. */
export interface Adder extends Named {
  kind: "adder";
  text: string;
  /** What is asked for, with the values chosen behind its own. */
  ask: Ask;
  lists: { label: string; options: Names }[];
}

/** Some of several names, as a list; none removes the key. */
export interface ChecksField extends Named {
  kind: "checks";
  options: { value: string; text: string }[];
  /** What holds where nothing is given. */
  usual?: string[];
  /** Whether one must stay. */
  needed?: boolean;
}

/** The name of a point or link, changed everywhere. */
export interface NameField {
  of: "point" | "link";
  name: string;
  label: string;
}

/** A button that changes the scene. */
export interface Button {
  text: string;
  icon?: "plus" | "remove" | "pin";
  /** Whether it is on, of a button that is on or off. */
  pressed?: boolean;
  /** Changes that it makes. */
  edits?: Edit[];
  /** Or what it asks for in the form's owner. */
  ask?: Ask;
}
