/** Drawings in the colours of a dark screen. */

/** The colours of a sheet on a dark screen, by the colour on paper. */
const darkened = new Map<string, string>();

/** A colour with its lightness turned round and its hue kept: white paper becomes dark, ink light. */
function dark(colour: string): string {
  const known = darkened.get(colour);
  if (known !== undefined) return known;
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) as [number, number, number];
  const shift = 255 - Math.max(red, green, blue) - Math.min(red, green, blue);
  // Not quite black, and not quite white: from 24 to 240; what is pale on paper stays a little lighter, or it would be lost.
  const mapped = [red, green, blue].map((part) => Math.round(24 + 216 * ((part + shift) / 255) ** 0.75));
  const made = `#${mapped.map((part) => Math.min(255, Math.max(0, part)).toString(16).padStart(2, "0")).join("")}`;
  darkened.set(colour, made);
  return made;
}

/** Whether the sheet is drawn on a dark ground already, as a blackboard is. */
function isDarkGround(svg: string): boolean {
  const ground = /<rect [^>]*fill="#([0-9a-f]{6})"/.exec(svg)?.[1];
  return ground !== undefined && parseInt(ground.slice(2, 4), 16) < 128;
}

/** The sheet in the colours of a dark screen. */
export function forDark(svg: string): string {
  return isDarkGround(svg) ? svg : svg.replace(/(fill|stroke)="(#[0-9a-f]{6})"/g, (_, what: string, colour: string) => `${what}="${dark(colour)}"`);
}
