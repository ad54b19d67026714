/** Arrow keys choose in a group of buttons of which one is chosen. */
export function radios(group: HTMLElement): void {
  group.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by === undefined) return;
    const all = [...group.querySelectorAll<HTMLElement>("[role=radio]")];
    const next = all[(all.indexOf(document.activeElement as HTMLElement) + by + all.length) % all.length];
    event.preventDefault();
    event.stopPropagation();
    next?.click();
    next?.focus();
  });
}
