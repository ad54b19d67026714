import { deflateSync, inflateSync, strFromU8, strToU8 } from "fflate";

/**
 * What a course keeps of a visit for the next one, as a text: the best score, and what is written in the form. A course keeps 4096 letters
 * (`cmi.suspend_data` of SCORM 1.2), so values stand without their names, in the order in which the exercise's empty form asks for them.
 */
const MOST = 4096;

/** Behind this stands a drawing's file, deflated, in base64: a plan of forty operations takes a thousand letters. */
type Deflated = string;

/** A value as a form has it; in brackets one in mm of paper. */
type Value = unknown;

/** A form as these letters hold it. */
interface Packed {
  v: 1;
  /** The best score, from 0 to 100. */
  b: number | null;
  /** What stands in the form above its values, the exercise's name among it. */
  h?: Record<string, unknown>;
  /** The values asked for, in their order; those that are not, by their names; places of points. */
  x?: Value[];
  f?: Record<string, Value>;
  p?: unknown;
  /** The drawing. */
  d?: Deflated;
}

type Form = Record<string, unknown> & { values?: Record<string, Value>; points?: unknown };

/** A form's text as an object; null where it is none. */
function read(text: string): Form | null {
  try {
    const form: unknown = JSON.parse(text);
    return typeof form === "object" && form !== null ? (form as Form) : null;
  } catch {
    return null;
  }
}

/** Behind a name: the value is in mm of paper. */
const ON_PAPER = "/mu";

/** What is to be kept of a form that was empty once. What has no room is left out as a whole, the points first: a part of it would be something else. */
export function packed(best: number | null, written: string, empty: string, drawing = ""): string {
  const form = read(written);
  const d = drawing === "" ? {} : { d: deflated(drawing) };
  if (form === null) return [{ v: 1, b: best, ...d } as Packed, { v: 1, b: best } as Packed].map(text).find((each) => each.length <= MOST)!;
  const { values = {}, points, ...head } = form;
  const asked = Object.keys(read(empty)?.values ?? {});
  const own = (name: string): Value => (name + ON_PAPER in values ? [values[name + ON_PAPER]] : (values[name] ?? ""));
  const further = Object.entries(values).filter(([name]) => !asked.includes(name) && !(name.endsWith(ON_PAPER) && asked.includes(name.slice(0, -ON_PAPER.length))));
  const all: Packed = { v: 1, b: best, h: head, x: asked.map(own), ...(further.length > 0 && { f: Object.fromEntries(further) }) };
  const tries = [...(points === undefined ? [] : [{ ...all, p: points, ...d }]), { ...all, ...d }, ...(points === undefined ? [] : [{ ...all, p: points }]), all].map(text);
  return tries.find((each) => each.length <= MOST) ?? text({ v: 1, b: best });
}

/** Letters of ASCII alone: what a course makes of others is not known. */
function text(kept: Packed): string {
  return JSON.stringify(kept).replace(/[^ -~]/g, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`);
}

const deflated = (drawing: string): Deflated => btoa(String.fromCharCode(...deflateSync(strToU8(drawing), { level: 9 })));

/** The drawing's text; empty where the letters are damaged. */
function inflated(letters: Deflated): string {
  try {
    return strFromU8(inflateSync(Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0))));
  } catch {
    return "";
  }
}

/** What an earlier visit has kept; null where it is nothing of the kind. */
export function unpacked(text: string): { best: number | null; drawing: string; into(empty: string): string | null } | null {
  const kept = read(text) as Packed | null;
  if (kept?.v !== 1) return null;
  return {
    drawing: typeof kept.d === "string" ? inflated(kept.d) : "",
    best: typeof kept.b === "number" && Number.isFinite(kept.b) ? kept.b : null,
    /** The form of the same exercise with what was written; null where there is none. */
    into(empty) {
      const form = read(empty);
      const { h: head, x, f = {}, p: points } = kept;
      const asked = Object.keys(form?.values ?? {});
      if (form === null || head?.["exercise"] !== form["exercise"] || !Array.isArray(x) || x.length !== asked.length) return null;
      const own = asked.map((name, index) => (Array.isArray(x[index]) ? [name + ON_PAPER, (x[index] as Value[])[0]] : [name, x[index]]) as [string, Value]);
      return `${JSON.stringify({ ...head, values: { ...Object.fromEntries(own), ...f }, ...(points !== undefined && { points }) }, null, 2)}\n`;
    },
  };
}
