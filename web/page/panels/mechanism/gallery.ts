/** The starting scenes, with pictures. */
import type { App } from "../../app.ts";
import { element } from "../../dom/element.ts";
import { icon } from "../../dom/icon.ts";
import type { Kind, Picture } from "../../engine/types.ts";
import { askedFor } from "../../files/open.ts";
import { openFile, READABLE } from "../../layout/brought.ts";
import { language } from "../../words.ts";
import { alone } from "../output/alone.ts";
import type { Box } from "../output/sheet.ts";
import { EMPTY, GROUPS, titleOf } from "./kinds.ts";
import { say } from "./words.ts";

/** The choice of a starting scene, closed at first; an empty one is begun in Build. */
export function gallery(app: App): HTMLElement {
  const summary = element("summary", {});
  const groups = element("div", { class: "kinds" });
  const root = element("details", { class: "gallery" }, summary, groups);
  const open = (text: string): void => {
    root.open = false;
    app.open(text);
    summary.focus();
  };
  const empty = element("button", { type: "button", class: "small" });
  empty.addEventListener("click", () => {
    // Nothing of what was there stays: neither its title nor its picture.
    if (app.history.now.value.text !== EMPTY) {
      app.solved.set({ text: "", opened: null, good: "", refused: null });
      app.picture.set(null);
    }
    open(EMPTY);
    // Also what stands there begins anew.
    app.building.set(false);
    app.building.set(true);
  });
  const browse = element("button", { type: "button", class: "small" });
  browse.addEventListener("click", () => void askedFor(READABLE).then((file) => openFile(app, file)));
  let drawn = false;
  root.addEventListener("toggle", () => {
    if (!root.open || drawn) return;
    drawn = true;
    void app.engine.kinds().then((kinds) => language.on(() => groups.replaceChildren(...grouped(app, kinds, open))));
  });
  language.on(() => {
    summary.textContent = say("change_kind");
    empty.replaceChildren(icon("plus"), say("empty"));
    browse.textContent = say("open_file");
  });
  return element("div", { class: "start" }, root, element("div", { class: "buttons" }, empty, browse));
}

function grouped(app: App, kinds: Kind[], open: (text: string) => void): HTMLElement[] {
  const listed = Object.values(GROUPS).flat();
  const others = kinds.filter(({ name }) => !listed.includes(name));
  return (Object.keys(GROUPS) as (keyof typeof GROUPS)[]).flatMap((group) => {
    const found = GROUPS[group].flatMap((name) => kinds.filter((kind) => kind.name === name));
    const all = group === "groups_bars" ? [...found, ...others] : found;
    if (all.length === 0) return [];
    return [element("section", {}, element("h3", {}, say(group)), element("div", { class: "cards" }, ...all.map((kind) => card(app, kind, open))))];
  });
}

function card(app: App, kind: Kind, open: (text: string) => void): HTMLElement {
  const sketch = element("span", { class: "sketch" });
  void thumbnail(app, kind.text).then((svg) => svg !== null && sketch.append(svg));
  const button = element("button", { type: "button", class: "kind" }, sketch, element("span", {}, titleOf(kind, language.value)));
  button.addEventListener("click", () => open(kind.text));
  return button;
}

/** A scene's mechanism, small; null where it cannot be drawn. */
async function thumbnail(app: App, text: string): Promise<HTMLElement | null> {
  try {
    const { picture, box } = await alone(app, text);
    return box === undefined ? null : cut(picture, box);
  } catch {
    return null;
  }
}

/** The mechanism in a picture, as an image by itself: nothing in it meets the page. */
function cut(picture: Picture, box: Box): HTMLElement | null {
  const svg = new DOMParser().parseFromString(picture.svg, "image/svg+xml").documentElement;
  if (svg.nodeName !== "svg") return null;
  svg.setAttribute("viewBox", box.join(" "));
  svg.setAttribute("width", String(box[2]));
  svg.setAttribute("height", String(box[3]));
  const address = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(svg)], { type: "image/svg+xml" }));
  return element("img", { src: address, alt: "", onload: () => URL.revokeObjectURL(address) });
}
