/** The element of this id, which index.html has. */
export function byId<Kind extends Element = HTMLElement>(id: string): Kind {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`index.html has no #${id}`);
  return found as unknown as Kind;
}

/** A new element with attributes and contents; texts are texts, never markup. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string> = {},
  ...contents: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...contents);
  return made;
}

/** Whether keys go into this element as letters. */
export function takesText(target: EventTarget | null): boolean {
  const found = target instanceof HTMLElement ? target : null;
  if (found === null) return false;
  return found.isContentEditable || (found.matches("input, textarea, select") && !found.matches("[type=range], [type=checkbox], [type=radio]"));
}
