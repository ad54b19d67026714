/** The third hand: a mechanism is put together, and changed, in place of the picture, also while it is not complete. */
import type { App } from "../app.ts";
import { element } from "../dom/element.ts";
import { byId } from "../dom/find.ts";
import { stateLine, toolRows } from "./bar.ts";
import { menu } from "./menu.ts";
import { placesIn } from "./hit.ts";
import { model, NOTHING } from "./model.ts";
import { stage } from "./stage.ts";

export function build(app: App): void {
  const own = model(app);
  const back = (): void => table.focus();
  const small = menu(app, own, back);
  const field = element("div", { class: "field" });
  const table = stage(app, own, field, small.open);
  const root = element("section", { id: "build", class: "floating", hidden: true }, toolRows(app, own, back), field, stateLine(app, own), small.root);
  byId("pane").append(root);

  /** The text whose mechanism the window was put on. */
  let isFitted = false;
  async function enter(): Promise<void> {
    // Where panels stand below the picture, there would be no room for it.
    if (window.innerWidth < 960) app.show("");
    own.sight.resize(field.clientWidth, field.clientHeight);
    await own.fresh();
    own.fit();
    isFitted = true;
    const isEmpty = (own.shown.value?.drafted.points.length ?? 0) === 0;
    own.tool.set(isEmpty ? "link" : "select");
    table.begin();
  }

  app.building.on((is) => {
    document.body.classList.toggle("building", is);
    root.hidden = !is;
    table.cancel();
    own.chosen.set(NOTHING);
    isFitted = false;
    if (!is) return;
    // At once: keys are the stage's from here on.
    table.focus();
    void enter();
  });
  // Another mechanism in place of the one that was there is looked for; what is built stays where it is, and so does who looks elsewhere.
  let before = new Set<string>();
  let seen = "";
  own.shown.on((shown) => {
    if (shown === null) return;
    const { width, height } = own.sight.size;
    const now = [width, height, shown.text].join();
    if (now === seen) return;
    seen = now;
    const places = placesIn(shown.drafted);
    const isOther = before.size > 0 && places.size > 0 && ![...places.keys()].some((name) => before.has(name));
    const isAway = places.size > 0 && ![...places.values()].some((place) => own.sight.holds(place));
    before = new Set(places.keys());
    if (isFitted && (isOther || isAway)) own.fit();
    const { points, links } = own.chosen.value;
    if ([...points].some((point) => !places.has(point))) own.chosen.set({ links, points: new Set([...points].filter((point) => places.has(point))) });
  });
}
