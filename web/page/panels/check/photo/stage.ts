import { element, svgElement } from "../../../dom/element.ts";
import type { PhotoPlan, PointVerdict } from "../../../engine/types.ts";
import { viewport, type Box, type Viewport } from "../../../look/viewport.ts";
import { letters } from "../plan_letters.ts";
import type { Photograph } from "./picture.ts";

/** A place in pixels, of the photograph or of the screen. */
export type Pixel = [number, number];

/** A point of the student as it is drawn over the photograph. */
export interface Mark extends PointVerdict {
  label: string;
  isChosen: boolean;
}

/** A place that is proposed for a point. */
export interface Guess {
  key: string;
  label: string;
  pixel: Pixel;
  isChosen: boolean;
  /** Whether it is where the right point is. */
  isNear: boolean;
}

/** What lies over the photograph. */
export interface Over {
  /** The right plans; none while they are off. */
  right: PhotoPlan[];
  marks: Mark[];
  guesses: Guess[];
}

export interface Stage {
  root: HTMLElement;
  view: Viewport;
  /** Shows a photograph, whole; null empties the stage. */
  show(photo: Photograph | null): void;
  over(what: Over): void;
  /** Draws a part of the photograph, round a place of it, into a canvas. */
  magnify(into: HTMLCanvasElement, at: Pixel, scale: number): void;
}

/** Signs of verdicts, as they stand beside values. */
export const SIGNS = { right: "✓", off: "✗", open: "?" } as const;

/** The verdict of the engine as a word of this page. */
export function kindOf({ verdict }: { verdict: string }): keyof typeof SIGNS {
  return verdict === "right" || verdict === "off" ? verdict : "open";
}

/** Most pixels of the screen for one of the page. */
const SHARPEST = 2;

/** The photograph on the screen with what lies over it: it follows the window onto it. */
export function stage(): Stage {
  const canvas = element("canvas", { "aria-hidden": "true" });
  const drawn = svgElement("svg", { "aria-hidden": "true" });
  const lines = svgElement("g");
  const marks = svgElement("g");
  drawn.append(lines, marks);
  const root = element("div", { class: "stage" }, canvas);
  root.append(drawn);
  const view = viewport(10);
  let photo: Photograph | null = null;
  /** What stands at places of the photograph. */
  let standing: { node: SVGElement; at: Pixel; radius?: SVGCircleElement; pixels?: number }[] = [];
  let isWaiting = false;

  /** The smallest copy of the photograph that is large enough for this scale, and its share of it. */
  function level(of: Photograph, scale: number): [HTMLCanvasElement, number] {
    const index = Math.max(0, Math.min(of.levels.length - 1, Math.floor(Math.log2(1 / Math.max(scale, 1e-6)))));
    return [of.levels[index]!, 0.5 ** index];
  }

  function draw(): void {
    isWaiting = false;
    const sharp = Math.min(SHARPEST, window.devicePixelRatio);
    const [width, height] = [Math.round(view.size.width * sharp), Math.round(view.size.height * sharp)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d");
    if (context === null) return;
    context.clearRect(0, 0, width, height);
    if (photo === null) return;
    const { scale } = view.now.value;
    const [left, top] = view.toPane([0, 0]);
    const [copy, share] = level(photo, scale * sharp);
    context.imageSmoothingEnabled = scale * sharp < 6;
    const size = (scale * sharp) / share;
    context.drawImage(copy, left * sharp, top * sharp, copy.width * size, copy.height * size);
    lines.setAttribute("transform", `translate(${left} ${top}) scale(${scale})`);
    for (const { node, at, radius, pixels } of standing) {
      node.setAttribute("transform", `translate(${view.toPane(at).join(" ")})`);
      radius?.setAttribute("r", String(Math.max(2, (pixels ?? 0) * scale)));
    }
  }
  function redraw(): void {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(draw);
  }
  view.now.on(redraw);
  new ResizeObserver(() => {
    if (root.clientWidth > 0) view.resize(root.clientWidth, root.clientHeight);
  }).observe(root);

  function named(label: string, x: number, y: number, className: string): SVGTextElement {
    const text = letters(label, label);
    for (const [name, value] of Object.entries({ x, y, class: className })) text.setAttribute(name, String(value));
    return text;
  }

  return {
    root,
    view,
    show(next) {
      photo = next;
      if (next !== null) view.fit([0, 0, next.width, next.height]);
      redraw();
    },
    over({ right, marks: own, guesses }) {
      standing = [];
      const stand = (node: SVGElement, at: Pixel): void => void standing.push({ node, at });
      // One name where both are at the same place.
      const isRight = new Set([...own.filter((mark) => kindOf(mark) !== "off").map(({ plan, name }) => `${plan}/${name}`), ...guesses.filter(({ isNear }) => isNear).map(({ key }) => key)]);
      const line = (places: number[][]): SVGElement => svgElement("path", { d: `M${places.map((at) => at.join(" ")).join("L")}` });
      lines.replaceChildren(...right.flatMap((plan) => plan.lines.map(line)));
      const rightPoints = right.flatMap(({ plan, points }) =>
        points.map(({ name, label, at }) => {
          const node = svgElement("g", { class: "right" }, svgElement("circle", { r: 3 }));
          if (!isRight.has(`${plan}/${name}`)) node.append(named(label, 6, -6, "name"));
          stand(node, at as Pixel);
          return node;
        }),
      );
      const guessed = guesses.map(({ key, label, pixel, isChosen }) => {
        const node = svgElement("g", { class: isChosen ? "guess chosen" : "guess", "data-key": key }, svgElement("circle", { class: "touch", r: 16 }), svgElement("circle", { r: 11 }), named(label, 13, 16, "name"));
        stand(node, pixel);
        return node;
      });
      const ownMarks = own.map((mark) => {
        const kind = kindOf(mark);
        const radius = svgElement("circle", { class: "band" });
        const node = svgElement("g", { class: mark.isChosen ? "mark chosen" : "mark", "data-kind": kind, "data-key": `${mark.plan}/${mark.name}` }, svgElement("circle", { class: "touch", r: 22 }), radius);
        if (mark.isChosen) node.append(svgElement("circle", { class: "ring", r: 15 }));
        node.append(svgElement("path", { class: "halo", d: CROSS }), svgElement("path", { d: CROSS }));
        const name = named(mark.label, 10, 20, "name");
        name.append(svgElement("tspan", { class: "sign", dx: 4 }, SIGNS[kind]));
        node.append(name);
        standing.push({ node, at: mark.pixel as Pixel, radius, pixels: mark.band_pixels });
        return node;
      });
      marks.replaceChildren(...rightPoints, ...guessed, ...ownMarks);
      redraw();
    },
    magnify(into, [x, y], scale) {
      const context = into.getContext("2d");
      if (photo === null || context === null) return;
      const [copy, share] = level(photo, scale);
      const size = scale / share;
      context.fillStyle = "#888";
      context.fillRect(0, 0, into.width, into.height);
      context.drawImage(copy, into.width / 2 - x * scale, into.height / 2 - y * scale, copy.width * size, copy.height * size);
    },
  };
}

/** A small cross. */
const CROSS = "M-7 0H7M0-7V7";

/** The part of the photograph in which plans are, with room for what was drawn wrongly. */
export function boxOf(plans: PhotoPlan[], { width, height }: Photograph, perMm: number): Box {
  const all = plans.flatMap((plan) => plan.points.map(({ at }) => at));
  const ends = [0, 1].map((axis) => [Math.min(...all.map((at) => at[axis]!)), Math.max(...all.map((at) => at[axis]!))]);
  const [[left, right], [top, bottom]] = ends as [Pixel, Pixel];
  const room = Math.max(15 * perMm, 0.3 * Math.max(right - left, bottom - top));
  const [x, y] = [Math.max(0, left - room), Math.max(0, top - room)];
  return [x, y, Math.min(width, right + room) - x, Math.min(height, bottom + room) - y];
}
