import { byId } from "../dom/find.ts";
import { signal } from "../state/signal.ts";
import type { Store } from "../state/storage.ts";

/** Whether the page is dark. */
export const isDark = signal(false);

/** As the system has it, until somebody chooses; the choice is kept. */
export function theme(store: Store): void {
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const chosen = (): string | null => store.preference("theme");
  let own = chosen();
  const follow = (): void => isDark.set(own === null ? system.matches : own === "dark");
  isDark.on((is) => (document.documentElement.dataset["theme"] = is ? "dark" : "light"));
  system.addEventListener("change", follow);
  byId("dark").onclick = () => {
    own = isDark.value ? "light" : "dark";
    store.prefer("theme", own);
    follow();
  };
  follow();
}
