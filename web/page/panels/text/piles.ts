import { Decoration, type DecorationSet, EditorView, MatchDecorator, ViewPlugin, type ViewUpdate, WidgetType } from "@codemirror/view";
import { element } from "../../dom/element.ts";
import { PILE } from "../../dom/piles.ts";

/** What stands in place of marks that are too many to be laid out. */
class Rest extends WidgetType {
  toDOM(): HTMLElement {
    return element("span", { class: "hint" }, "…");
  }
}

const found = new MatchDecorator({ regexp: PILE, decoration: Decoration.replace({ widget: new Rest() }) });

class Piles {
  decorations: DecorationSet;
  constructor(view: EditorView) {
    this.decorations = found.createDeco(view);
  }
  update(update: ViewUpdate): void {
    this.decorations = found.updateDeco(update, this.decorations);
  }
}

/** Leaves marks out of sight that nobody could tell apart; the text keeps them, and the cursor steps over them as over one letter. */
export const piles = ViewPlugin.fromClass(Piles, {
  decorations: ({ decorations }) => decorations,
  provide: (plugin) => EditorView.atomicRanges.of((view) => view.plugin(plugin)?.decorations ?? Decoration.none),
});
