/** What is being built: the tool, what is chosen, the mechanism as far as it is known, and the changes that hands make. */
import type { App } from "../app.ts";
import type { Drafted } from "../engine/types.ts";
import { edit } from "../panels/parts/edits.ts";
import { newId } from "../panels/parts/fields.ts";
import { parsed, unitsOf } from "../panels/parts/scene.ts";
import { paneOf } from "../picture/surface.ts";
import { said } from "../refused.ts";
import { newest } from "../state/newest.ts";
import { signal, type Signal } from "../state/signal.ts";
import type { Chosen, Copied } from "./copied.ts";
import type { Photograph } from "./ground.ts";
import { linkAt, placesIn, pointAt } from "./hit.ts";
import { dragged, handlesOf, loadAt, type Dragged, type LoadPress } from "./seen_loads.ts";
import { short, sight, type Place, type Sight, type Sighted } from "./sight.ts";
import type { Choices, Follows, Press, Present, Tool } from "./tools.ts";
import { say } from "./words.ts";

/** The mechanism on the screen: of a text, seen so. */
export interface Shown {
  text: string;
  at: Sighted;
  drafted: Drafted;
}

/** Points that are held and moved together. */
export interface Held {
  /** So far from where they were. */
  move(by: Place): void;
  /** Lets go: one entry of undo. */
  drop(): Promise<void>;
  cancel(): void;
}

export interface Model {
  sight: Sight;
  tool: Signal<Tool>;
  choices: Signal<Choices>;
  snaps: Signal<boolean>;
  /** Where a tool was pressed first, that goes from one place to another. */
  begun: Signal<Press | null>;
  chosen: Signal<Chosen>;
  shown: Signal<Shown | null>;
  photo: Signal<Photograph | null>;
  /** Places of the photograph whose distance will be told; null where nobody sets its scale. */
  scaling: Signal<Place[] | null>;
  /** What keeps held points from following; empty where nothing does. */
  note: Signal<string>;
  copied: Copied | null;
  /** What is there by now; null where the text is no scene at all. */
  present(): Present | null;
  /** Waits until the stage shows the text as it is. */
  fresh(): Promise<void>;
  /** Does it after all that was begun before: however quick hands are, each act finds what the one before has made. */
  inTurn(act: () => unknown): Promise<void>;
  /** What is at a place; where nothing is, the place is put on the grid. */
  press(place: Place, reach: number): Press;
  /** Makes the changes, as one entry of undo; or says what they need. */
  make(follows: Follows, gesture?: string): Promise<boolean>;
  hold(names: Iterable<string>): Held;
  /** Takes hold of a load. */
  holdLoad(load: LoadPress): Held;
  /** What can be taken hold of of loads, where tools take it. */
  handles(): LoadPress[];
  /** The load that is dragged, with what it has come to. */
  dragging: Signal<Dragged | null>;
  /** Shows everything. */
  fit(): void;
  redraw(): void;
}

export const NOTHING: Chosen = { points: new Set(), links: new Set() };

/** Points that are closer than so many steps of the grid are in one place. */
const SAME = 0.05;

/** Tools that take hold of loads. */
const TAKE_LOADS: readonly Tool[] = ["select", "load"];

/** Half the width of a block, in the height of letters. */
const BLOCK = 0.8;

export function model(app: App): Model {
  const own = sight();
  const shown = signal<Shown | null>(null);
  const note = signal("");
  const tool = signal<Tool>("link");
  const begun = signal<Press | null>(null);
  const dragging = signal<Dragged | null>(null);
  const snaps = signal(true);
  /** The text that is shown while something is held. */
  let preview: string | null = null;
  const letters = (): number => paneOf(own.size.width, own.size.height).letters;

  const drawing = newest(async ({ text, at }: { text: string; at: Sighted }) => {
    const { width, height } = own.size;
    try {
      const drafted = await app.engine.drafted(text, { pane: { width, height, letters: letters(), words: false }, centre: [...at.centre], scale: at.scale });
      shown.set({ text, at, drafted });
      if (preview === null) note.set("");
    } catch (refused) {
      note.set(said(refused));
    }
  });
  const redraw = (): void => {
    if (app.building.value) drawing.want({ text: preview ?? app.history.now.value.text, at: own.now.value });
  };

  function present(): Present | null {
    const scene = parsed(app.history.now.value.text);
    return scene === null || shown.value === null ? null : { scene, drafted: shown.value.drafted, places: placesIn(shown.value.drafted), grain: own.grid().fine };
  }

  async function fresh(): Promise<void> {
    redraw();
    while (!drawing.isIdle()) await new Promise((done) => setTimeout(done, 4));
  }

  let turn = Promise.resolve();
  function inTurn(act: () => unknown): Promise<void> {
    const done = turn.then(async () => void (await act()));
    turn = done.catch(() => undefined);
    return done;
  }

  /** A millimetre of the picture in units of length. */
  const mm = ({ drafted }: Present): number => own.size.width / drafted.width / own.now.value.scale;

  function handles(): LoadPress[] {
    const there = present();
    return there === null || !TAKE_LOADS.includes(tool.value) || begun.value !== null ? [] : handlesOf(there, mm(there));
  }

  function press(place: Place, reach: number): Press {
    const there = present();
    const grid = own.rounded(place, snaps.value);
    if (there === null) return { at: grid, under: place, point: null, link: null };
    const { scene, places } = there;
    const far = reach / own.now.value.scale;
    // No second point comes to lie where one is.
    const point = pointAt(places, place, far) ?? pointAt(places, grid, SAME * own.grid().fine);
    const link = linkAt(scene, places, place, far, (BLOCK * letters()) / own.now.value.scale);
    const held = handles().length === 0 ? null : loadAt(there, mm(there), place, far);
    const toPoint = point === null ? Infinity : Math.hypot(places.get(point)![0] - place[0], places.get(point)![1] - place[1]);
    if (held !== null && held.away < toPoint) return { at: held.load.at, under: place, point: null, link, load: held.load };
    return { at: point === null ? grid : places.get(point)!, under: place, point, link };
  }

  /** Whether it is still said what was needed last. */
  let hasTold = false;
  async function make(follows: Follows, gesture: string = newId()): Promise<boolean> {
    if (follows.length === 0) return false;
    const why = typeof follows === "string" ? say(follows) : await edit(app, follows, gesture).then((refused) => refused && said(refused));
    if (why !== null || hasTold) app.tell(why ?? "");
    hasTold = why !== null;
    await fresh();
    return why === null;
  }

  /** What is held follows: `change` gives the text for a way, or null where it stays as it is. */
  function held(change: (by: Place) => Promise<string | null>, ends: () => void = () => undefined): Held {
    let last = app.history.now.value.text;
    let isOver = false;
    const moving = newest(async (by: Place) => {
      try {
        const next = await change(by);
        if (isOver || next === null) return;
        note.set("");
        last = preview = next;
        redraw();
      } catch (refused) {
        note.set(said(refused));
      }
    });
    const over = (): void => {
      isOver = true;
      preview = null;
      note.set("");
      ends();
      redraw();
    };
    return {
      move: (by) => moving.want(by),
      async drop() {
        while (!moving.isIdle()) await new Promise((done) => setTimeout(done, 4));
        if (isOver) return;
        app.history.change({ text: last });
        over();
      },
      cancel: over,
    };
  }

  function hold(names: Iterable<string>): Held {
    const text = app.history.now.value.text;
    const places = present()?.places ?? new Map<string, Place>();
    const origins = [...names].flatMap((name): [string, Place][] => (places.has(name) ? [[name, places.get(name)!]] : []));
    return held(async ([dx, dy]) => {
      const moves = origins.map(([name, [x, y]]) => ({ name, at: [short(x + dx), short(y + dy)] as Place }));
      return app.engine.move_points(text, moves);
    });
  }

  function holdLoad(load: LoadPress): Held {
    const [text, there] = [app.history.now.value.text, present()];
    const change = async (by: Place): Promise<string | null> => {
      const now = there === null ? null : dragged({ ...there, isOnGrid: snaps.value }, load, by);
      if (now === null) return null;
      const next = await app.engine.edit_in_place(text, now.edits);
      dragging.set(now);
      return next;
    };
    return held(change, () => dragging.set(null));
  }

  function fit(): void {
    const there = present();
    own.fit(there === null ? [] : [...there.places.values()], unitsOf(there?.scene ?? {}).length);
  }

  app.history.now.on(redraw);
  own.now.on(redraw);
  return {
    sight: own,
    tool,
    choices: signal<Choices>({ sliding: "block", guided: "along" }),
    snaps,
    begun,
    chosen: signal(NOTHING),
    shown,
    photo: signal<Photograph | null>(null),
    scaling: signal<Place[] | null>(null),
    note,
    copied: null,
    present,
    fresh,
    inTurn,
    press,
    make,
    hold,
    holdLoad,
    handles,
    dragging,
    fit,
    redraw,
  };
}
