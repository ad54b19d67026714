/** Units as people type them behind numbers. */
import { evaluated } from "./number.ts";

/** Exponents of length, time, angle and mass. */
type Dimension = readonly [number, number, number, number];

const NEWTON = 9.80665;
const POUND = 0.45359237;

/** The size of each unit in metres, seconds, radians and kilograms, and its dimension. */
const UNITS: Readonly<Record<string, readonly [number, Dimension]>> = {
  mm: [1e-3, [1, 0, 0, 0]],
  cm: [1e-2, [1, 0, 0, 0]],
  dm: [1e-1, [1, 0, 0, 0]],
  m: [1, [1, 0, 0, 0]],
  in: [0.0254, [1, 0, 0, 0]],
  ft: [0.3048, [1, 0, 0, 0]],
  ms: [1e-3, [0, 1, 0, 0]],
  s: [1, [0, 1, 0, 0]],
  min: [60, [0, 1, 0, 0]],
  rad: [1, [0, 0, 1, 0]],
  "°": [Math.PI / 180, [0, 0, 1, 0]],
  deg: [Math.PI / 180, [0, 0, 1, 0]],
  rev: [2 * Math.PI, [0, 0, 1, 0]],
  g: [1e-3, [0, 0, 0, 1]],
  kg: [1, [0, 0, 0, 1]],
  t: [1e3, [0, 0, 0, 1]],
  lb: [POUND, [0, 0, 0, 1]],
  slug: [(POUND * NEWTON) / 0.3048, [0, 0, 0, 1]],
  blob: [(POUND * NEWTON) / 0.0254, [0, 0, 0, 1]],
  mN: [1e-3, [1, -2, 0, 1]],
  N: [1, [1, -2, 0, 1]],
  kN: [1e3, [1, -2, 0, 1]],
  kgf: [NEWTON, [1, -2, 0, 1]],
  lbf: [POUND * NEWTON, [1, -2, 0, 1]],
};

/** Revolutions a minute, and radians in the other rates, as machines and tables have them. */
const SAME: Readonly<Record<string, string>> = { rpm: "rev/min", "1/min": "rev/min", "min-1": "rev/min", "min⁻¹": "rev/min", "r/min": "rev/min", "U/min": "rev/min", "1/s": "rad/s", "s-1": "rad/s", "s⁻¹": "rad/s" };

/** The size and the dimension of a unit such as `N·mm`, `m/s^2`, `rpm`; null of what is none. */
function unitOf(text: string): readonly [number, Dimension] | null {
  const plain = text.replace(/\s/g, "").replace("º", "°");
  let size = 1;
  const dimension: [number, number, number, number] = [0, 0, 0, 0];
  for (const [index, side] of (Object.hasOwn(SAME, plain) ? SAME[plain]! : plain).split("/").entries()) {
    for (const part of side.split(/[·*]/)) {
      const [, name = "", power = ""] = /^(.+?)(?:\^?([23]|²|³))?$/.exec(part) ?? [];
      const known = Object.hasOwn(UNITS, name) ? UNITS[name] : undefined;
      if (known === undefined) return null;
      const exponent = (index === 0 ? 1 : -1) * (Number({ "²": 2, "³": 3 }[power] ?? power) || 1);
      size *= known[0] ** exponent;
      known[1].forEach((own, at) => (dimension[at]! += exponent * own));
    }
  }
  return [size, dimension];
}

/** How many of one unit are one of another; null where one is none, or of another kind. */
export function converted(from: string, to: string): number | null {
  const [own, other] = [unitOf(from), unitOf(to)];
  if (own === null || other === null || own[1].some((exponent, at) => exponent !== other[1][at])) return null;
  return own[0] / other[0];
}

/** What a unit begins with: a letter, a degree, `1/min`. */
const BEGINS = /^(?:[\p{L}°º]|1\/)/u;

/** Most letters of a number with its unit: whoever writes more has written something else. */
const LONGEST = 60;

/** A number, or a formula, and the unit behind it where one stands there. */
export function parted(typed: string): { number: string; unit: string | null } {
  const text = typed.trim();
  if (evaluated(text) !== null) return { number: text, unit: null };
  // The longest number before a unit.
  for (let at = Math.min(text.length, LONGEST) - 1; at > 0; at -= 1) {
    const [number, unit] = [text.slice(0, at).trim(), text.slice(at)];
    if (BEGINS.test(unit) && evaluated(number) !== null) return { number, unit };
  }
  return { number: text, unit: null };
}

/** What somebody typed, in this unit; a unit that cannot become it is named; null where no number stands there. */
export function measured(typed: string, unit: string): number | { unit: string } | null {
  const { number, unit: own } = parted(typed);
  const value = evaluated(number);
  if (value === null || own === null || own === unit) return value;
  const factor = converted(own, unit);
  // No more digits than a number of the computer has.
  return factor === null ? { unit: own } : Number((value * factor).toPrecision(15));
}
