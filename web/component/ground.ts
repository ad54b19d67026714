/** On what a plan stands: hosts choose light and dark by classes of their own, which nobody can know; the colour behind it tells. */

/** Whether the page is dark behind an element. */
export function isOnDark(element: Element): boolean {
  for (let at: Element | null = element.parentElement; at !== null; at = at.parentElement ?? hostOf(at)) {
    const [red = 0, green = 0, blue = 0, alpha = 1] = (getComputedStyle(at).backgroundColor.match(/[\d.]+/g) ?? []).map(Number);
    if (alpha > 0.5) return 0.299 * red + 0.587 * green + 0.114 * blue < 110;
  }
  return window.matchMedia("(prefers-color-scheme: dark)").matches && getComputedStyle(document.documentElement).colorScheme.includes("dark");
}

function hostOf(element: Element): Element | null {
  const root = element.getRootNode();
  return root instanceof ShadowRoot ? root.host : null;
}

const watching = new Map<Element, () => void>();

function look(): void {
  // Colours that ease over are there a moment later.
  for (const wait of [0, 400]) window.setTimeout(() => watching.forEach((act) => act()), wait);
}

let isWatching = false;

/** Calls `act` when the page may have become dark or light; null ends that. */
export function watchGround(element: Element, act: (() => void) | null): void {
  if (act === null) return void watching.delete(element);
  watching.set(element, act);
  if (isWatching) return;
  isWatching = true;
  const changes = new MutationObserver(look);
  for (const root of [document.documentElement, document.body]) changes.observe(root, { attributes: true });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", look);
}
