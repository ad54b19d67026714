import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

/** Colours of the page, so that light and dark need nothing of their own. */
export const look = [
  EditorView.theme({
    "&": { color: "var(--ink)", backgroundColor: "var(--paper)", height: "100%", fontSize: ".9rem" },
    "&.cm-focused": { outline: "2px solid var(--accent)" },
    ".cm-scroller": { fontFamily: "ui-monospace, 'Cascadia Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace", lineHeight: "1.5" },
    ".cm-content": { caretColor: "var(--ink)", padding: ".5rem 0" },
    ".cm-cursor": { borderLeftColor: "var(--ink)" },
    ".cm-gutters": { color: "var(--quiet)", backgroundColor: "var(--back)", borderRight: "1px solid var(--line)" },
    ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--accent) 9%, transparent)" },
    "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
      backgroundColor: "color-mix(in srgb, var(--accent) 30%, transparent)",
    },
    "&.cm-focused .cm-matchingBracket": { backgroundColor: "color-mix(in srgb, var(--good) 30%, transparent)" },
    ".cm-foldPlaceholder": { color: "var(--quiet)", backgroundColor: "transparent", borderColor: "var(--line)" },
    ".cm-tooltip, .cm-panels": { color: "var(--ink)", backgroundColor: "var(--paper)", border: "1px solid var(--line)" },
    ".cm-tooltip": { borderRadius: "6px", maxWidth: "min(28rem, 90vw)" },
    ".cm-tooltip-autocomplete ul li[aria-selected]": { color: "var(--paper)", backgroundColor: "var(--accent)" },
    ".cm-completionInfo": { padding: ".4rem .6rem" },
    ".cm-diagnostic-error": { borderLeftColor: "var(--bad)" },
    ".cm-searchMatch": { backgroundColor: "color-mix(in srgb, var(--warn) 30%, transparent)" },
    ".cm-textfield, .cm-button": { color: "var(--ink)", backgroundColor: "var(--back)", backgroundImage: "none", borderColor: "var(--line)" },
  }),
  syntaxHighlighting(
    HighlightStyle.define([
      { tag: tags.propertyName, color: "var(--accent)" },
      { tag: tags.string, color: "var(--good)" },
      { tag: [tags.number, tags.bool, tags.null], color: "var(--warn)" },
      { tag: [tags.separator, tags.squareBracket, tags.brace], color: "var(--quiet)" },
    ]),
  ),
];
