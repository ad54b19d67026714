/** Numbers as people type them, and as they are shown. */

const TOKEN = /\s*(?:((?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[-+−]?\d+)?)|(pi\b|π)|(sqrt\b|√)|([-+*/^()−–·×:]))/iy;
const SIGNS: Record<string, string> = { "−": "-", "–": "-", "·": "*", "×": "*", ":": "/" };

type Token = number | string;

/** The parts of an expression; null where something else stands in it. */
function tokens(text: string): Token[] | null {
  const found: Token[] = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const token = TOKEN.exec(text);
    if (token === null) return null;
    const [, digits, pi, root, sign] = token;
    if (digits !== undefined) found.push(Number(digits.replace(",", ".").replace("−", "-")));
    else if (pi !== undefined) found.push(Math.PI);
    else if (root !== undefined) found.push("√");
    else if (sign !== undefined) found.push(SIGNS[sign] ?? sign);
  }
  return found;
}

/** The value of `60`, `2,5`, `1/3`, `2*pi`, `2π`, `(3+4)/2`, `sqrt(2)*100`, `2^0.5`; null for everything else. */
export function evaluated(typed: string): number | null {
  const rest = tokens(typed.trim());
  if (rest === null) return null;
  const sum = (): number => {
    let value = product();
    while (rest[0] === "+" || rest[0] === "-") value += (rest.shift() === "+" ? 1 : -1) * product();
    return value;
  };
  const product = (): number => {
    let value = power();
    for (;;) {
      if (rest[0] === "*") rest.shift(), (value *= power());
      else if (rest[0] === "/") rest.shift(), (value /= power());
      else if (rest[0] === Math.PI || rest[0] === "(" || rest[0] === "√") value *= power();
      else return value;
    }
  };
  /** A sign is weaker than a power: −2² is −4. */
  const power = (): number => {
    if (rest[0] === "-") return rest.shift(), -power();
    if (rest[0] === "+") return rest.shift(), power();
    const base = factor();
    return rest[0] === "^" ? (rest.shift(), base ** power()) : base;
  };
  const factor = (): number => {
    const token = rest.shift();
    if (typeof token === "number") return token;
    if (token === "√") return Math.sqrt(factor());
    if (token !== "(") return Number.NaN;
    const inner = sum();
    return rest.shift() === ")" ? inner : Number.NaN;
  };
  const value = sum();
  return rest.length === 0 && Number.isFinite(value) ? value : null;
}

/** A number with the mark that the scene asks for. */
export function shownNumber(value: number, comma: boolean): string {
  const digits = String(value).replace("e+", "e");
  return comma ? digits.replace(".", ",") : digits;
}

/** How far one press of an arrow key goes for values of that size: between an eightieth of a percent and an eightieth. */
export function stepFor(size: number): number {
  return size > 0 && Number.isFinite(size) ? 10 ** (Math.floor(Math.log10(size * 1.25)) - 2) : 1;
}

/** A value after some steps, on whole steps and with no more digits than they have. */
export function stepped(value: number, step: number, count: number): number {
  const next = Math.round(value / step + count) * step;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return Number(next.toFixed(Math.min(digits, 20)));
}
