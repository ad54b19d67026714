import { syntaxTree } from "@codemirror/language";
import type { EditorState } from "@codemirror/state";
import type { SyntaxNode } from "@lezer/common";

/** Where a place of the text is in the scene: its path, and whether it is in a key or a value. */
export interface Spot {
  path: string[];
  isKey: boolean;
  /** The text of the key or value there, in which the place is. */
  from: number;
  to: number;
}

/** The spot of a place. */
export function spotAt(state: EditorState, place: number): Spot {
  const node = syntaxTree(state).resolveInner(place, -1);
  const isKey = node.name === "PropertyName" || node.name === "Object" || node.name === "{";
  const isWord = ["PropertyName", "String", "Number", "True", "False", "Null"].includes(node.name);
  const word = isWord ? node : null;
  return { path: pathOf(state, node), isKey, from: word?.from ?? place, to: word?.to ?? place };
}

/** The path of what a node is in; of a key that of its value. */
function pathOf(state: EditorState, node: SyntaxNode): string[] {
  const path: string[] = [];
  for (let inner: SyntaxNode | null = node; inner !== null; inner = inner.parent) {
    const outer = inner.parent;
    if (inner.name === "Property") path.unshift(keyOf(state, inner));
    else if (outer?.name === "Array" && inner.name !== "[" && inner.name !== "]") path.unshift(String(indexOf(outer, inner)));
  }
  return path;
}

function keyOf(state: EditorState, property: SyntaxNode): string {
  const name = property.getChild("PropertyName");
  return name === null ? "" : state.sliceDoc(name.from, name.to).replaceAll('"', "");
}

function indexOf(list: SyntaxNode, element: SyntaxNode): number {
  let index = -1;
  for (let child = list.firstChild; child !== null; child = child.nextSibling) {
    if (!["[", "]", ","].includes(child.name)) index += 1;
    if (child.from === element.from) return Math.max(index, 0);
  }
  return Math.max(index, 0);
}
