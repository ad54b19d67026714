import type { App, Panel } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { icon } from "../dom/icon.ts";
import type { Store } from "../state/storage.ts";
import { STUDENTS_PANEL } from "../state/studying.ts";
import { language } from "../words.ts";

/** The panels beside the picture, one at a time, by tabs. Pressing the shown panel's tab hides it. */
export function tabs(app: App, panels: Panel[], store: Store): void {
  const list = byId("tabs");
  const place = byId("panels");
  const buttons = panels.map((panel) => {
    const text = element("span");
    const button = element("button", { type: "button", role: "tab", id: `tab-${panel.id}`, "aria-controls": `panel-${panel.id}` }, icon(panel.id), text);
    const root = element("section", { role: "tabpanel", id: `panel-${panel.id}`, "aria-labelledby": `tab-${panel.id}`, class: "panel" });
    const heading = element("h2");
    const body = element("div", { class: "body" });
    language.on(() => (text.textContent = heading.textContent = panel.title()));
    root.append(heading, body);
    place.append(root);
    list.append(button);
    button.onclick = () => app.shown.set(app.shown.value === panel.id ? "" : panel.id);
    return { id: panel.id, button, root, body };
  });
  // A panel is filled when somebody first wants to see it.
  const waiting = new Map(panels.map((panel) => [panel.id, panel]));
  const fill = (id: string, body: HTMLElement): void => {
    const panel = waiting.get(id);
    waiting.delete(id);
    panel?.mount(body, app);
  };

  list.onkeydown = (event) => {
    const seen = buttons.filter(({ button }) => !button.hidden);
    const at = seen.findIndex(({ button }) => button === document.activeElement);
    const next = { ArrowDown: at + 1, ArrowRight: at + 1, ArrowUp: at - 1, ArrowLeft: at - 1, Home: 0, End: seen.length - 1 }[event.key];
    if (next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const to = seen[(next + seen.length) % seen.length];
    to?.button.focus();
    if (to !== undefined && app.shown.value !== "") app.shown.set(to.id);
  };

  app.student.on((is) => {
    for (const { id, button } of buttons) button.hidden = is && id !== STUDENTS_PANEL;
    if (is && app.shown.value !== "") app.show(STUDENTS_PANEL);
  });

  app.shown.on((shown) => {
    byId("side").classList.toggle("folded", shown === "");
    document.body.classList.toggle("folded", shown === "");
    const focusable = buttons.some(({ id }) => id === shown) ? shown : buttons[0]?.id;
    for (const { id, button, root, body } of buttons) {
      if (id === shown) fill(id, body);
      button.setAttribute("aria-selected", String(id === shown));
      button.tabIndex = id === focusable ? 0 : -1;
      root.hidden = id !== shown;
      if (id === shown) button.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
    store.prefer("panel", shown);
  });
}
