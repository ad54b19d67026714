import { signal, type Signal } from "../state/signal.ts";

/** A rectangle on the sheet in mm: left, top, width, height. */
export type Box = readonly [number, number, number, number];

/** Which part of the sheet the pane shows. */
export interface Window {
  /** The place in the middle of the pane, in mm. */
  readonly x: number;
  readonly y: number;
  /** Pixels per mm. */
  readonly scale: number;
}

/** The window onto the sheet: it fits a box into the pane until somebody zooms or pans. */
export interface Viewport {
  readonly now: Signal<Window>;
  /** Size of the pane in pixels. */
  readonly size: { width: number; height: number };
  /** The box that is shown alone; null where somebody has zoomed or panned. */
  alone(): Box | null;
  /** Whether more is zoomed in than fits. */
  isZoomed(): boolean;
  /** The pane has another size. */
  resize(width: number, height: number): void;
  /** Tells when what {@link room} says may be other. */
  readonly resized: Pick<Signal<unknown>, "on">;
  /** Width and height that a picture fills, in pixels. */
  room(): { width: number; height: number };
  /** So many pixels above the picture are for other things; null where it has all of the pane. */
  keepFree(above: number | null): void;
  /** Shows this box whole; as long as nobody zooms, also when the pane changes. */
  fit(box: Box): void;
  /** Fits again what was fitted last. */
  refit(): void;
  /** Zooms by a factor about a place of the pane in pixels. */
  zoom(factor: number, about: [number, number]): void;
  pan(dx: number, dy: number): void;
  toSheet(pixels: [number, number]): [number, number];
  toPane(mm: readonly [number, number]): [number, number];
}

/** Room around what is fitted, in pixels; above it buttons may stand. */
const MARGIN = 6;
const ABOVE = 54;
/** How much larger than fitting, and how much smaller. */
const [LEAST, MOST] = [0.5, 40];

export function viewport(above = ABOVE): Viewport {
  const now = signal<Window>({ x: 148.5, y: 105, scale: 1 });
  const size = { width: 1, height: 1 };
  let box: Box = [0, 0, 297, 210];
  let isOwn = false;
  let head = above;
  const resized = signal({});

  const room = (): { width: number; height: number } => ({ width: size.width - 2 * MARGIN, height: size.height - MARGIN - head });
  const fitting = (): number => Math.max(1e-3, Math.min(room().width / box[2], room().height / box[3]));

  function refit(): void {
    isOwn = false;
    const whole = fitting();
    const next = { x: box[0] + box[2] / 2, y: box[1] + box[3] / 2 - (head - MARGIN) / 2 / whole, scale: whole };
    const { x, y, scale } = now.value;
    if (next.x !== x || next.y !== y || next.scale !== scale) now.set(next);
  }

  function toSheet([px, py]: [number, number]): [number, number] {
    const { x, y, scale } = now.value;
    return [x + (px - size.width / 2) / scale, y + (py - size.height / 2) / scale];
  }

  return {
    now,
    size,
    alone: () => (isOwn ? null : box),
    isZoomed: () => isOwn && now.value.scale > fitting() * 1.01,
    resize(width, height) {
      const before = fitting();
      Object.assign(size, { width, height });
      if (!isOwn) refit();
      // Who has zoomed keeps what is seen in sight. Told also where the window stays, as the pane's height alone decides.
      const scale = isOwn ? (now.value.scale * fitting()) / before : now.value.scale;
      now.set({ ...now.value, scale });
      resized.set({});
    },
    resized,
    room,
    keepFree(above) {
      head = above ?? MARGIN;
      if (!isOwn) refit();
      resized.set({});
    },
    fit(next) {
      box = next;
      refit();
    },
    refit,
    zoom(factor, about) {
      const [x, y] = toSheet(about);
      const scale = Math.min(Math.max(now.value.scale * factor, fitting() * LEAST), fitting() * MOST);
      isOwn = true;
      now.set({ x: x - (about[0] - size.width / 2) / scale, y: y - (about[1] - size.height / 2) / scale, scale });
    },
    pan(dx, dy) {
      const { x, y, scale } = now.value;
      isOwn = true;
      const within = (value: number, from: number, length: number): number => Math.min(Math.max(value, from), from + length);
      now.set({ x: within(x - dx / scale, box[0], box[2]), y: within(y - dy / scale, box[1], box[3]), scale });
    },
    toSheet,
    toPane(mm) {
      const { x, y, scale } = now.value;
      return [(mm[0] - x) * scale + size.width / 2, (mm[1] - y) * scale + size.height / 2];
    },
  };
}
