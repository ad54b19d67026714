/** The element of this id, which index.html has, or the component's own tree. */
export function byId<Kind extends Element = HTMLElement>(id: string, root: Document | ShadowRoot = document): Kind {
  const found = root.getElementById(id);
  if (found === null) throw new Error(`there is no #${id}`);
  return found as unknown as Kind;
}

/** Whether keys go into this element as letters. */
export function takesText(target: EventTarget | null): boolean {
  const found = target instanceof HTMLElement ? target : null;
  if (found === null) return false;
  return found.isContentEditable || (found.matches("input, textarea, select") && !found.matches("[type=range], [type=checkbox], [type=radio]"));
}
