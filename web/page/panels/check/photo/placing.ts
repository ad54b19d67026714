import type { Photo, PhotoPlan } from "../../../engine/types.ts";
import { scaleOf } from "../../../sheets.ts";
import { type FormFile, type Place, placesOf, withHead, withPlace } from "../form.ts";

/** A pole that is farther than this from the printed one, in mm, was measured on other paper. */
const OTHER_PAPER = 5;

/** A point of a sheet's plan, by its plan and its name. */
export const keyOf = (plan: string, name: string): string => `${plan}/${name}`;

/** The places of a plan's points in mm from the pole as it is printed. What was measured on other paper is laid on it by its own pole. */
export function placesOn(file: FormFile, plan: PhotoPlan): Record<string, Place> {
  const places = placesOf(file, plan.plan);
  const pole = places[plan.points[0]?.name ?? ""];
  if (pole === undefined || Math.hypot(pole[0], pole[1]) < OTHER_PAPER) return places;
  const moved = Object.entries(places).map(([name, [x, y, band]]): [string, Place] => [name, placed(x - pole[0], y - pole[1], band)]);
  return Object.fromEntries(moved);
}

function placed(x: number, y: number, band?: number): Place {
  const round = (mm: number): number => Math.round(100 * mm) / 100;
  return band === undefined ? [round(x), round(y)] : [round(x), round(y), band];
}

/** The form with a point at a place of the sheet: its scale and its pole are the printed ones. */
export function withPoint(file: FormFile, plan: PhotoPlan, { band: sheet }: Photo, name: string, at: [number, number], band: number | null): FormFile {
  const own = plan.plan;
  const scaled = withHead(file, scaleOf(own), plan.mu);
  let next = Object.entries(placesOn(file, plan)).reduce((form, [other, place]) => withPlace(form, own, other, place), scaled);
  const pole = plan.points[0]?.name ?? "";
  const known = (radius: number | null): number | undefined => (radius === null ? undefined : Math.round(100 * radius) / 100);
  if (placesOn(file, plan)[pole] === undefined) next = withPlace(next, own, pole, placed(0, 0, known(sheet)));
  return withPlace(next, own, name, placed(at[0], at[1], known(band)));
}

/** The form without a point. */
export function withoutPoint(file: FormFile, plan: PhotoPlan, name: string): FormFile {
  return withPlace(file, plan.plan, name, null);
}
