/** One sheet on the screen: the engine's picture of it, and over it what hands and keys are about to do. */
import type { App } from "../app.ts";
import { element, svgElement } from "../dom/element.ts";
import { icon } from "../dom/icon.ts";
import { worded } from "../dom/worded.ts";
import { name } from "../layout/say.ts";
import { isDark } from "../layout/theme.ts";
import { viewport, type Viewport } from "../look/viewport.ts";
import { forDark } from "../picture/dark.ts";
import { fill, withoutPaper } from "../picture/sheet.ts";
import { said } from "../refused.ts";
import { called, type Sheet } from "../sheets.ts";
import { newest } from "../state/newest.ts";
import { language } from "../words.ts";
import type { Judging } from "./judging.ts";
import { loupe, type Loupe } from "./loupe.ts";
import type { Model } from "./model.ts";
import type { BoardSheet, Ghost, Snapped } from "../engine/types.ts";
import { say } from "./words.ts";

/** A place on a sheet, in mm from its upper left corner. */
export type Place = [number, number];

/** Letters are at least so high on the screen, in pixels; on paper so many mm. */
const [READ, PRINTED] = [12, 3.5];

export interface Stage {
  readonly sheet: Sheet;
  readonly root: HTMLElement;
  /** What takes hands and keys. */
  readonly over: SVGSVGElement;
  readonly view: Viewport;
  readonly loupe: Loupe;
  /** Where keys are; null while a pointer is used. */
  cursor: Place | null;
  /** What a press would add, beside the hand; null where there is nothing. */
  aim(snap: Snapped | null): void;
  /** Draws what lies over the sheet anew. */
  draw(): void;
}

export function stage(app: App, model: Model, judging: Judging, sheet: Sheet): Stage {
  const view = viewport(10);
  const drawn = svgElement("svg", { class: "drawn", "aria-hidden": "true" });
  const over = svgElement("svg", { class: "over", tabindex: 0, role: "application", "data-sheet": sheet });
  const words = element("div", { class: "words", "aria-hidden": "true", hidden: true });
  const scale = element("small");
  const title = element("div", { class: "title" }, worded(element("b"), () => called(sheet, "short")), scale);
  const fit = element("button", { type: "button", class: "fit", onclick: () => view.refit() }, icon("fit"));
  language.on(() => name(fit, say("fit")));
  const glass = loupe(view, drawn, over);
  const root = element("div", { class: "sheet", "data-sheet": sheet }, title);
  root.append(drawn, over, words, glass.root, fit);

  let size: BoardSheet | null = null;
  let svg = "";
  let aimed: Snapped | null = null;

  function paint(): void {
    if (svg !== "") fill(drawn, isDark.value ? forDark(svg) : svg);
  }

  const picturing = newest(async () => {
    const known = model.known.value;
    const until = model.until.value;
    // Not every scene has every sheet.
    if (known === null || size === null || root.hidden || !app.drawing.value) return;
    const letters = view.now.value.scale * PRINTED < READ ? READ / view.now.value.scale : null;
    try {
      const picture = await app.engine.board_picture(known.scene, model.pictured.value, { sheet, until, letters, judged: judging.verdicts.value !== null });
      svg = withoutPaper(picture.svg);
      paint();
    } catch (refused) {
      model.says.set({ text: said(refused), isBad: true });
    }
  });

  function look(): void {
    const { width, height } = view.size;
    const [left, top] = view.toSheet([0, 0]);
    const { scale: now } = view.now.value;
    for (const each of [drawn, over]) each.setAttribute("viewBox", `${left} ${top} ${width / now} ${height / now}`);
    // For tests: where a place of the sheet is on the screen.
    over.dataset["window"] = JSON.stringify([left, top, now]);
    draw();
  }

  const path = ({ kind, path: d }: Ghost, more = ""): SVGElement => svgElement("path", { d, class: `ghost ${kind} ${more}` });

  let isWaiting = false;
  function draw(): void {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      const now = view.now.value.scale;
      const shown = model.shown.value;
      const marks = shown !== null && shown.sheet === sheet ? shown.ghost.map((each) => path(each, shown.kind)) : [];
      const ghosts = aimed?.ghost.map((each) => path(each)) ?? [];
      const ring = aimed === null ? [] : [svgElement("circle", { class: "aimed", cx: aimed.at[0], cy: aimed.at[1], r: 7 / now })];
      const at = document.activeElement === over ? own.cursor : null;
      const arm = 12 / now;
      const cross = at === null ? [] : [svgElement("path", { class: "cursor", d: `M${at[0] - arm} ${at[1]}h${2 * arm}M${at[0]} ${at[1] - arm}v${2 * arm}` })];
      over.replaceChildren(...marks, ...ghosts, ...ring, ...cross);
      words.hidden = aimed === null || aimed.words === "";
      if (aimed === null) return;
      words.textContent = aimed.words;
      const [x, y] = view.toPane(aimed.at);
      const [wide, high] = [words.offsetWidth, words.offsetHeight];
      words.style.transform = `translate(${Math.max(4, Math.min(x + 14, view.size.width - wide - 4))}px, ${Math.max(4, y - high - 14)}px)`;
    });
  }

  const own: Stage = {
    sheet,
    root,
    over,
    view,
    loupe: glass,
    cursor: null,
    aim(snap) {
      aimed = snap;
      draw();
    },
    draw,
  };

  function follow(): void {
    const next = model.known.value?.sheets.find((each) => each.sheet === sheet) ?? null;
    root.classList.toggle("missing", next === null);
    if (next === null) return void (size = null);
    scale.textContent = [next.scale, next.pole === null ? null : model.known.value?.hand].filter(Boolean).join(" · ");
    if (size === null || size.width !== next.width || size.height !== next.height) view.fit([0, 0, next.width, next.height]);
    size = next;
  }

  model.known.on(follow);
  judging.verdicts.on(() => picturing.want(undefined));
  model.pictured.on(() => picturing.want(undefined));
  model.until.on(() => picturing.want(undefined));
  model.shown.on(draw);
  isDark.on(paint);
  language.on(() => over.setAttribute("aria-label", say("sheet", { name: called(sheet, "name") })));
  view.now.on(look);
  new ResizeObserver(() => {
    if (root.clientWidth === 0) return;
    view.resize(root.clientWidth, root.clientHeight);
    picturing.want(undefined);
  }).observe(root);
  return own;
}
