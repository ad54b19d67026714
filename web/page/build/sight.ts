/** What of the mechanism is seen while it is built: a window of its own onto the scene's coordinates, which moves only when somebody moves it. */
import { signal, type Signal } from "../state/signal.ts";

/** A place in the scene's own coordinates, y up. */
export type Place = [number, number];
/** A place in pixels from the upper left corner, y down. */
export type Pixels = [number, number];

/** The place in the middle, and pixels for a unit of length. */
export interface Sighted {
  readonly centre: Place;
  readonly scale: number;
}

export interface Sight {
  readonly now: Signal<Sighted>;
  readonly size: { width: number; height: number };
  resize(width: number, height: number): void;
  toScene(pixels: Pixels): Place;
  toPane(place: readonly [number, number]): Pixels;
  zoom(factor: number, about: Pixels): void;
  pan(dx: number, dy: number): void;
  /** Shows all places with room around them; without any, about 300 mm. */
  fit(places: Place[], unit: string): void;
  /** Whether a place is seen. */
  holds(place: Place): boolean;
  /** The distance of the grid's lines, and of those with numbers. */
  grid(): { fine: number; named: number };
  /** The place on the grid, or on a round number of the last digit that a pixel tells. */
  rounded(place: Place, snaps: boolean): Place;
}

/** Least distance of the grid's lines, in pixels. */
const APART = 13;
/** White on each side of what is fitted: in pixels, and at most in parts of the stage. */
const [WHITE, SHARE] = [70, 0.12];

export function sight(): Sight {
  const now = signal<Sighted>({ centre: [0, 0], scale: 3 });
  const size = { width: 1, height: 1 };
  const toScene = ([x, y]: Pixels): Place => {
    const { centre, scale } = now.value;
    return [centre[0] + (x - size.width / 2) / scale, centre[1] - (y - size.height / 2) / scale];
  };
  const toPane = ([x, y]: readonly [number, number]): Pixels => {
    const { centre, scale } = now.value;
    return [(x - centre[0]) * scale + size.width / 2, size.height / 2 - (y - centre[1]) * scale];
  };
  function grid(): { fine: number; named: number } {
    const least = APART / now.value.scale;
    const ten = 10 ** Math.floor(Math.log10(least));
    const part = [1, 2, 5, 10].find((each) => each * ten >= least) ?? 10;
    return { fine: short(part * ten), named: short(part * ten * (part === 2 ? 5 : 10)) };
  }
  return {
    now,
    size,
    toScene,
    toPane,
    grid,
    resize: (width, height) => void Object.assign(size, { width: Math.max(1, width), height: Math.max(1, height) }),
    zoom(factor, about) {
      const [x, y] = toScene(about);
      const scale = Math.min(Math.max(now.value.scale * factor, 1e-4), 1e6);
      now.set({ centre: [x - (about[0] - size.width / 2) / scale, y + (about[1] - size.height / 2) / scale], scale });
    },
    pan(dx, dy) {
      const { centre, scale } = now.value;
      now.set({ centre: [centre[0] - dx / scale, centre[1] + dy / scale], scale });
    },
    fit(places, unit) {
      const room = { mm: 300, cm: 30, m: 0.3, in: 12, ft: 1 }[unit] ?? 300;
      const [across, up] = [places.map(([x]) => x), places.map(([, y]) => y)];
      const [left, right] = places.length === 0 ? [-0.2 * room, 0.8 * room] : [Math.min(...across), Math.max(...across)];
      const [low, high] = places.length === 0 ? [-0.2 * room, 0.4 * room] : [Math.min(...up), Math.max(...up)];
      const [wide, tall] = [Math.max(right - left, 0.2 * room, 1e-9), Math.max(high - low, 0.2 * room, 1e-9)];
      const inner = (side: number): number => side - 2 * Math.min(WHITE, SHARE * side);
      const scale = Math.min(inner(size.width) / wide, inner(size.height) / tall);
      now.set({ centre: [(left + right) / 2, (low + high) / 2], scale });
    },
    holds(place) {
      const [x, y] = toPane(place);
      return x >= 0 && y >= 0 && x <= size.width && y <= size.height;
    },
    rounded(place, snaps) {
      const step = snaps ? grid().fine : 10 ** Math.floor(Math.log10(1 / now.value.scale));
      return place.map((value) => short(Math.round(value / step) * step)) as Place;
    },
  };
}

/** A number without the dust of binary fractions. */
export function short(value: number): number {
  return Number(value.toPrecision(10)) + 0;
}
