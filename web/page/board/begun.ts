/** How a drawing begins: with the exercise it is of, and with what a photograph shows. */
import type { App } from "../app.ts";
import type { BoardUse } from "../state/address.ts";
import { formFile } from "../panels/check/form.ts";
import { scaleOf, type Sheet } from "../sheets.ts";
import { goodText } from "../state/solving.ts";
import { drawingOf, drawingText, type Drawing } from "./file.ts";

/** How the board is used where no link says it. */
const USUAL: BoardUse = { mode: "practice", snap: "all", at_once: false };
export const useOf = (app: App): BoardUse => app.board.value ?? USUAL;

/** An empty drawing with its exercise, whose it is, the hints that were opened, and what the hand is helped with. */
export function begunWith(app: App, empty: string): string {
  const { exercise, name, hints } = formFile(app.history.now.value.form) ?? {};
  const { did = [], ...head } = drawingOf(empty) ?? { kinegon_drawing: 1 as const };
  return drawingText({ ...head, ...(name && { name }), ...(exercise && { exercise }), ...(hints && { hints }), snap: useOf(app).snap, did });
}

/** A plan's points on paper: in mm from its pole at a scale in units per mm. */
export interface OnPaper {
  sheet: Sheet;
  mu: number;
  points: [name: string, x: number, y: number][];
}

/** Goes on, on the board, with points that stand on paper; those that are drawn there already stay as they are. */
export async function goOnWith(app: App, plans: readonly OnPaper[]): Promise<void> {
  const scene = await goodText(app);
  const empty = (await app.engine.board(scene, "")).drawing;
  const text = app.history.now.value.drawing || begunWith(app, empty);
  const drawing: Drawing = { ...drawingOf(empty), ...(drawingOf(text) ?? { kinegon_drawing: 1, did: [] }) };
  const { things } = await app.engine.board(scene, text);
  const isThere = (sheet: Sheet, name: string): boolean => things.some((thing) => thing.kind === "point" && thing.sheet === sheet && thing.name === name);
  const marks = plans.flatMap(({ sheet, mu, points }) => {
    const scale = mu / (drawing[scaleOf(sheet)] ?? mu);
    const round = (mm: number): number => Math.round(100 * mm * scale) / 100;
    return points.filter(([name]) => !isThere(sheet, name)).map(([name, x, y]) => ({ mark: name, on: sheet, drawn: [round(x), round(y)] }));
  });
  if (marks.length > 0) app.history.draw(drawingText({ ...drawing, did: [...drawing.did, ...marks] }));
  app.drawing.set(true);
}
