/**
 * Puts a drawing into the page in place of the one before, and leaves what has stayed: while a mechanism moves, most elements are the same with
 * other numbers. The browser then neither makes nor styles them anew.
 */
import { drafts, keyOf, piecesOf, textOf, type Draft } from "./drafts.ts";

/** A draft in the page. */
interface Part {
  line: string;
  key: string;
  /** The tags and words of the line, once they have been asked for. */
  pieces?: string[];
  element: Element;
  inner: Part[] | null;
}

/** The parts of each drawing that has been put somewhere. */
const known = new WeakMap<Element, Part[]>();

/** So many parts that are gone may stand before one that has stayed. */
const AHEAD = 12;

/** Fills an element with a drawing; afterwards it holds the same as if it had been filled by `innerHTML`. */
export function patch(root: SVGElement, markup: string): void {
  const next = drafts(markup);
  const before = known.get(root);
  if (next === null || before === undefined || before.length !== root.childElementCount || !isAlike(before, next)) {
    root.innerHTML = markup;
    if (next === null) known.delete(root);
    else known.set(root, partsOf(root, next));
    return;
  }
  known.set(root, aligned(root, before, next));
}

/** Whether so much may have stayed that it is worth looking for. */
function isAlike(before: Part[], next: Draft[]): boolean {
  return Math.abs(before.length - next.length) <= AHEAD && before[0]?.key === keyOf(next[0]);
}

function partsOf(parent: Element, all: Draft[]): Part[] {
  return all.map((draft, index) => partOf(parent.children[index]!, draft));
}

function partOf(element: Element, draft: Draft): Part {
  return { line: draft.line, key: keyOf(draft), element, inner: draft.inner && partsOf(element, draft.inner) };
}

const holder = document.createElementNS("http://www.w3.org/2000/svg", "svg");

function made(draft: Draft): Part {
  holder.innerHTML = textOf(draft);
  return partOf(holder.firstElementChild!, draft);
}

/** How far on from `from` a key stands; AHEAD where it is farther, or nowhere. */
function distance(keys: string[], from: number, key: string | undefined): number {
  let way = 0;
  while (way < AHEAD && keys[from + way] !== key) way += 1;
  return way;
}

/** Makes the children of an element those of the drafts; behind each stands the end of its line. */
function aligned(parent: Element, before: Part[], next: Draft[]): Part[] {
  const [old, keys] = [before.map(({ key }) => key), next.map(keyOf)];
  let at = 0;
  const away = ({ element }: Part): void => {
    element.nextSibling?.remove();
    element.remove();
  };
  const parts = next.map((draft, index) => {
    // Whichever costs less: that parts have gone before this one, or that this one is new before those.
    const gone = distance(old, at, keys[index]);
    if (gone === AHEAD || distance(keys, index, old[at]) < gone) {
      const fresh = made(draft);
      const place = before[at]?.element ?? null;
      parent.insertBefore(fresh.element, place);
      parent.insertBefore(document.createTextNode("\n"), place);
      return fresh;
    }
    before.slice(at, at + gone).forEach(away);
    const stayed = before[at + gone]!;
    at += gone + 1;
    if (follows(stayed, draft)) return stayed;
    const fresh = made(draft);
    stayed.element.replaceWith(fresh.element);
    return fresh;
  });
  before.slice(at).forEach(away);
  return parts;
}

/** Makes a part what the draft says; false where it is of another kind. */
function follows(part: Part, draft: Draft): boolean {
  if ((part.inner === null) !== (draft.inner === null)) return false;
  if (part.line !== draft.line && !renumbered(part, draft.line)) return false;
  part.line = draft.line;
  if (part.inner !== null && draft.inner !== null) part.inner = aligned(part.element, part.inner, draft.inner);
  return true;
}

/** Gives the elements of a part the attributes of another line with the same tags and the same words; false where it has not. */
function renumbered(part: Part, to: string): boolean {
  if (to.includes("&")) return false;
  const [old, now] = [part.pieces ?? piecesOf(part.line), piecesOf(to)];
  if (old.length !== now.length) return false;
  part.pieces = now;
  const elements = now.length < 3 ? [part.element] : [part.element, ...part.element.querySelectorAll("*")];
  let at = 0;
  return now.every((piece, index) => {
    const own = piece.startsWith("<") && !piece.startsWith("</") ? elements[at++] : undefined;
    return piece === old[index] || (own !== undefined && reset(own, old[index]!, piece));
  });
}

const ATTRIBUTES = /[\w:-]+="[^"]*"/g;

/** The same for one element. */
function reset(element: Element, from: string, to: string): boolean {
  const [old, now] = [from.match(ATTRIBUTES) ?? [], to.match(ATTRIBUTES) ?? []];
  if (old.length !== now.length || from.split(/[ />]/, 1)[0] !== to.split(/[ />]/, 1)[0]) return false;
  return now.every((attribute, index) => {
    if (attribute === old[index]) return true;
    const end = attribute.indexOf("=");
    const name = attribute.slice(0, end);
    if (!old[index]!.startsWith(`${name}=`)) return false;
    element.setAttribute(name, attribute.slice(end + 2, -1));
    return true;
  });
}
