/** Two fingers and the wheel, which zoom and pan whatever is looked at. */

/** A place in pixels from the upper left corner of the element. */
export type Pixels = [number, number];

/** The window onto it. */
interface Look {
  zoom(factor: number, about: Pixels): void;
  pan(dx: number, dy: number): void;
}

/** The fingers, or the mouse, that are down on an element. */
export interface Fingers {
  /** Where an event is, in pixels from the element's corner. */
  at(event: MouseEvent): Pixels;
  /** One more is down: how many there are now. */
  press(event: PointerEvent): number;
  /** One moves. Where it was, while it is down alone; null where it is not down, and where two zoom and pan. */
  move(event: PointerEvent): Pixels | null;
  /** One is lifted: how many are left; null where it was not down. */
  lift(event: PointerEvent): number | null;
}

export function fingers(root: HTMLElement | SVGSVGElement, view: Look): Fingers {
  const down = new Map<number, Pixels>();
  const at = ({ clientX, clientY }: MouseEvent): Pixels => {
    const { left, top } = root.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };

  /** What is between two fingers stays between them. */
  function pinch(before: Pixels, now: Pixels, other: Pixels): void {
    const spread = (a: Pixels): number => Math.max(8, Math.hypot(a[0] - other[0], a[1] - other[1]));
    view.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    view.zoom(spread(now) / spread(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
  }

  (root as HTMLElement).addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      event.stopPropagation();
      if (event.shiftKey) return view.pan(-event.deltaY - event.deltaX, 0);
      const lines = event.deltaMode === 1 ? 16 : 1;
      view.zoom(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0016)), at(event));
    },
    { passive: false },
  );

  return {
    at,
    press(event) {
      down.set(event.pointerId, at(event));
      root.setPointerCapture(event.pointerId);
      return down.size;
    },
    move(event) {
      const before = down.get(event.pointerId);
      if (before === undefined) return null;
      const now = at(event);
      down.set(event.pointerId, now);
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
      if (other === undefined) return before;
      pinch(before, now, other);
      return null;
    },
    lift: (event) => (down.delete(event.pointerId) ? down.size : null),
  };
}
