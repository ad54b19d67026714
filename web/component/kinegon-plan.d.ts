/** A scene file, as `kinegon schema scene` describes it. */
export type Scene = Record<string, unknown>;

/** A step of the construction. */
export interface Step {
  /** Counted from 1. */
  number: number;
  /** What is done. */
  caption: string;
  /** Its equation in plain text, or empty. */
  equation: string;
  /** What it gives besides: sizes and directions, rates, angles. */
  values: string[];
  /** The sheet on which it is drawn. */
  panel: "scheme" | "velocity" | "acceleration";
}

/** A value with those of its digits that are certain. */
export interface Value {
  /** As `v(D).size`. */
  name: string;
  /** As HTML of `<i>`, `<sub>`, `<sup>` and text alone. */
  label: string;
  value: string;
  unit: string;
  /** How far it can be from the true one, in the same unit. */
  error?: string;
}

/** The verdict on measured values. */
export interface Checked {
  /** As `kinegon check --json`; null where no value is understood. */
  result: { passed: boolean; values: { quantity: string; value: number; expected: number; verdict: string }[] } & Record<string, unknown> | null;
  /** As `kinegon check` prints it. */
  report: string;
  /** Values that are not understood. */
  faults: { name: string; message: string; hint: string | null }[];
}

export interface KinegonPlanEventMap {
  /** The first picture stands. */
  "kinegon-ready": CustomEvent<{ title: string; steps: number }>;
  /** Another step is shown; `step` is null for the finished plans. */
  "kinegon-step": CustomEvent<{ step: number | null; count: number; caption: string }>;
  /** The mechanism stands elsewhere, or is another: `text` is the scene file. */
  "kinegon-change": CustomEvent<{ text: string }>;
  "kinegon-play": CustomEvent<{ playing: boolean }>;
  /** The scene could not be read or solved; `line` is its line, counted from 1. */
  "kinegon-error": CustomEvent<{ message: string; line: number | null }>;
}

/** `<kinegon-plan src="…" step="…" controls theme="…">` */
export interface KinegonPlan extends HTMLElement {
  /** Settles when the first picture stands, or the scene is refused. */
  readonly ready: Promise<void>;
  /** The scene as it stands; null before it is solved. A text or an object may be set. */
  get scene(): Scene | null;
  set scene(scene: Scene | string);
  /** The step after which it is shown, from 1; null for the finished plans. */
  step: number | null;
  readonly steps: readonly Step[];
  readonly playing: boolean;
  next(): void;
  back(): void;
  play(): void;
  pause(): void;
  /** All rates, velocities and accelerations. Rejects with the refusal of a scene that cannot be solved. */
  values(): Promise<Value[]>;
  /** The verdict on measured values: by their names, or a whole form as `kinegon check` reads it. */
  check(form: Record<string, unknown> | string): Promise<Checked>;
  addEventListener<Name extends keyof KinegonPlanEventMap>(name: Name, listener: (this: KinegonPlan, event: KinegonPlanEventMap[Name]) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(name: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "kinegon-plan": KinegonPlan;
  }
}
