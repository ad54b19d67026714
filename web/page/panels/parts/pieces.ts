/** Pieces of a form: each stays while its description stays, so that an edit builds what it changes and no more. */
import { element } from "../../dom/element.ts";
import { owned } from "../../state/signal.ts";
import type { Live } from "./fields.ts";
import type { Draft } from "./scene.ts";

/** Pieces of one list that are built at once; further ones are when they come near to what is seen: of a thousand links nobody sees more. */
const AT_ONCE = 40;

/** How near, in heights of what is seen. */
const NEAR = "100% 0px";

interface Piece {
  root: HTMLElement;
  /** What it was built from. */
  shape: string;
  live: Live[];
  end(): void;
}

export interface Pieces {
  /** The piece of this key: the one that is there if it was built from the same; `live` gets what shows values of the scene. */
  of(key: string, described: unknown, build: (live: Live[]) => HTMLElement): HTMLElement;
  /** Whether the piece of this key, at this place of its list, is to be built by now. */
  isNear(key: string, index: number): boolean;
  /** What stands in its place until then. */
  later(key: string, path: string): HTMLElement;
  /** Ends what was not asked for since the last time; shows the scene in what was. */
  show(scene: Draft): void;
  /** Ends all. */
  clear(): void;
}

/** The pieces of a form in `body`; `again` is called when further ones come near. */
export function pieces(body: HTMLElement, again: () => void): Pieces {
  let last = new Map<string, Piece>();
  let now = new Map<string, Piece>();
  const near = new Set<string>();
  const observer = new IntersectionObserver((seen) => {
    const coming = seen.filter(({ isIntersecting }) => isIntersecting);
    for (const { target } of coming) near.add((target as HTMLElement).dataset["later"]!);
    if (coming.length > 0) again();
  }, { root: body.closest("#panels"), rootMargin: NEAR });

  function of(key: string, described: unknown, build: (live: Live[]) => HTMLElement): HTMLElement {
    const shape = JSON.stringify(described);
    const old = now.get(key) ?? last.get(key);
    if (old?.shape === shape) {
      now.set(key, old);
      return old.root;
    }
    const live: Live[] = [];
    const { made, end } = owned(() => build(live));
    now.set(key, { root: made, shape, live, end });
    return made;
  }
  return {
    of,
    isNear: (key, index) => index < AT_ONCE || near.has(key),
    later: (key, path) =>
      of(key, "later", () => {
        const place = element("div", { class: "later", "data-later": key, "data-path": path });
        observer.observe(place);
        return place;
      }),
    show(scene) {
      for (const [key, piece] of last) {
        if (now.get(key) === piece) continue;
        piece.end();
        observer.unobserve(piece.root);
      }
      last = now;
      now = new Map();
      for (const { live } of last.values()) for (const each of live) each.show(scene);
    },
    clear() {
      for (const piece of last.values()) piece.end();
      last = new Map();
    },
  };
}

/** Makes these the children of an element; those that are there stay where they are, with what has the focus in them. */
export function settled<Parent extends HTMLElement>(parent: Parent, children: HTMLElement[]): Parent {
  const staying = new Set<Element>(children);
  for (const child of [...parent.children]) if (!staying.has(child)) child.remove();
  let place = parent.firstElementChild;
  for (const child of children) {
    if (child === place) place = place.nextElementSibling;
    else parent.insertBefore(child, place);
  }
  return parent;
}
