import { element, svgElement } from "../../dom/element.ts";
import type { PlanPoint } from "../../engine/types.ts";
import type { Place } from "./form.ts";
import { letters } from "./plan_letters.ts";
import { say } from "./words.ts";

/** The sheet before anything is on it, in mm. */
const USUAL = { left: 0, bottom: 0, right: 180, top: 120 };
/** White around the points, in mm. */
const MARGIN = 15;

interface Events {
  /** The chosen point is put here. */
  placed(at: Place): void;
  /** A point is dragged. */
  dragged(name: string, at: Place, isOver: boolean): void;
}

export interface PlanSheet {
  root: HTMLElement;
  show(points: PlanPoint[], places: Record<string, Place>, chosen: string): void;
  focus(): void;
}

/** Squared paper for the points of a plan. Places are in mm, x to the right, y up; on the SVG y is down. */
export function planSheet(events: Events): PlanSheet {
  const paper = svgElement("svg", { class: "paper", tabindex: "0", role: "application" });
  const squares = svgElement("g", { class: "squares" });
  const drawn = svgElement("g");
  const cross = svgElement("path", { class: "cross", d: "M-4 0H4M0-4V4" });
  paper.append(squares, drawn, cross);
  let sheet = { ...USUAL };
  let cursor: Place = [40, 60];
  let held: string | null = null;
  let zoom = 1;

  /** A place under the pointer, to the half millimetre, or finer where the sheet is large enough. */
  function under(event: PointerEvent): Place {
    const box = paper.getBoundingClientRect();
    const mm = (sheet.right - sheet.left) / box.width;
    const fine = mm < 0.2 ? 10 : 2;
    const round = (x: number): number => Math.round(x * fine) / fine;
    return [round(sheet.left + (event.clientX - box.left) * mm), round(sheet.top - (event.clientY - box.top) * mm)];
  }

  paper.onpointerdown = (event) => {
    const point = (event.target as Element).closest<SVGElement>("[data-point]");
    if (point === null) return;
    held = point.dataset["point"] ?? null;
    paper.setPointerCapture(event.pointerId);
    event.preventDefault();
  };
  paper.onpointermove = (event) => {
    if (held !== null) events.dragged(held, under(event), false);
  };
  paper.onpointerup = (event) => {
    if (held !== null) events.dragged(held, under(event), true);
  };
  paper.onclick = (event) => {
    if (held === null) events.placed(under(event as PointerEvent));
    held = null;
  };
  paper.onpointercancel = () => (held = null);
  paper.onkeydown = (event) => {
    const step = event.shiftKey ? 0.1 : event.altKey ? 10 : 1;
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (way !== undefined) {
      cursor = ([0, 1] as const).map((axis) => Math.round((cursor[axis] + (way[axis] ?? 0) * step) * 10) / 10) as Place;
      moveCross();
      paper.setAttribute("aria-label", `${cursor[0]} mm, ${cursor[1]} mm`);
    } else if (event.key === "Enter" || event.key === " ") events.placed([...cursor]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  const at = ([x, y]: Place): [number, number] => [x - sheet.left, sheet.top - y];
  function moveCross(): void {
    cross.setAttribute("transform", `translate(${at(cursor).join(" ")})`);
  }

  /** The sheet grows with what is on it; it never shrinks under the hand. */
  function fit(places: Place[]): void {
    if (held !== null) return;
    const grown = { ...USUAL };
    for (const [x, y] of places) {
      grown.left = Math.min(grown.left, 10 * Math.floor((x - MARGIN) / 10));
      grown.right = Math.max(grown.right, 10 * Math.ceil((x + MARGIN) / 10));
      grown.bottom = Math.min(grown.bottom, 10 * Math.floor((y - MARGIN) / 10));
      grown.top = Math.max(grown.top, 10 * Math.ceil((y + MARGIN) / 10));
    }
    sheet = grown;
    const [width, height] = [sheet.right - sheet.left, sheet.top - sheet.bottom];
    paper.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const lines = (from: number, to: number, line: (x: number) => string): string =>
      Array.from({ length: Math.floor((to - from) / 5) + 1 }, (_, index) => line(5 * index)).join("");
    squares.replaceChildren(svgElement("path", { d: lines(0, width, (x) => `M${x} 0V${height}`) + lines(0, height, (y) => `M0 ${y}H${width}`) }));
  }

  const scroller = element("div", { class: "scroller" });
  scroller.append(paper);
  const zoomButton = (sign: string, factor: number): HTMLButtonElement => {
    const made = element("button", { type: "button", "aria-label": sign === "+" ? "+" : "−" }, sign);
    made.onclick = () => {
      zoom = Math.min(8, Math.max(1, zoom * factor));
      paper.style.width = `${100 * zoom}%`;
    };
    return made;
  };
  const root = element("div", { class: "plan-sheet" }, scroller, element("div", { class: "zoom" }, zoomButton("−", 0.5), zoomButton("+", 2)));

  return {
    root,
    focus: () => paper.focus({ preventScroll: true }),
    show(points, places, chosen) {
      fit(Object.values(places));
      paper.setAttribute("aria-label", say("points_sheet"));
      const own = places[chosen];
      if (own !== undefined) cursor = [...own];
      moveCross();
      const pole = points[0] === undefined ? undefined : places[points[0].name];
      const labels = new Map(points.map((point) => [point.name, point.label]));
      const rays = Object.values(places).map((place) => {
        if (pole === undefined || place === pole) return "";
        return `M${at(pole).join(" ")}L${at(place).join(" ")}`;
      });
      const marks = Object.entries(places).map(([name, place]) => {
        const [x, y] = at(place);
        const mark = svgElement("g", { class: name === chosen ? "point chosen" : "point", "data-point": name, transform: `translate(${x} ${y})` });
        mark.append(svgElement("circle", { class: "touch", r: "5" }), svgElement("circle", { class: "dot", r: "1" }), letters(labels.get(name), name));
        return mark;
      });
      drawn.replaceChildren(svgElement("path", { class: "rays", d: rays.join("") }), ...marks);
    },
  };
}
