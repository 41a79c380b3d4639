/** The editor's colours and sizes. Colours are variables of the page's style sheet, so that they
 * follow its theme. */
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const theme = EditorView.theme({
  "&": {
    height: "100%",
    color: "var(--ink)",
    backgroundColor: "var(--code-ground)",
    fontSize: "1.3rem",
  },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-scroller": {
    fontFamily: "ui-monospace, SFMono-Regular, Menlo, Consolas, 'DejaVu Sans Mono', monospace",
    lineHeight: "1.5",
    overscrollBehavior: "contain",
  },
  ".cm-content": { caretColor: "var(--ink)", padding: "8px 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": {
    color: "var(--faint)",
    backgroundColor: "var(--code-ground)",
    borderRight: "1px solid var(--edge)",
  },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--code-line)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    backgroundColor: "var(--code-selection)",
  },
  ".cm-selectionBackground": { backgroundColor: "var(--code-selection)" },
  "&.cm-focused .cm-matchingBracket": {
    backgroundColor: "var(--code-selection)",
    outline: "1px solid var(--faint)",
  },
  ".cm-selectionMatch, .cm-searchMatch": { backgroundColor: "var(--code-match)" },
  ".cm-searchMatch-selected": { backgroundColor: "var(--code-selection)" },
  ".cm-foldPlaceholder": { color: "var(--faint)", background: "none", borderColor: "var(--edge)" },
  ".cm-panels, .cm-tooltip": {
    color: "var(--ink)",
    backgroundColor: "var(--code-raised)",
    borderColor: "var(--edge)",
  },
  ".cm-panel.cm-search": { padding: "6px 8px" },
  ".cm-panel.cm-search label": { fontSize: "1.25rem" },
  ".cm-panel.cm-search [name=close]": { color: "var(--ink)", fontSize: "1.8rem", width: "2.8rem" },
  ".cm-textfield": {
    color: "var(--ink)",
    backgroundColor: "var(--code-ground)",
    border: "1px solid var(--faint)",
    borderRadius: "5px",
  },
  ".cm-button": {
    color: "var(--ink)",
    background: "none",
    border: "1px solid var(--faint)",
    borderRadius: "5px",
  },
  // A list wider than the panel would be cut off; at this width its lines end in an ellipsis.
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { maxWidth: "min(54rem, 92vw)" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": {
    color: "var(--accent-ink)",
    backgroundColor: "var(--accent)",
  },
  ".cm-tooltip-autocomplete > ul > li[aria-selected] .cm-completionDetail": {
    color: "var(--accent-ink)",
  },
  ".cm-completionDetail": { color: "var(--faint)", fontStyle: "normal" },
  // CodeMirror's own marks are images with data: addresses, which the page's content security
  // policy forbids.
  ".cm-lintRange-error": {
    backgroundImage: "none",
    textDecoration: "underline wavy var(--over)",
    textUnderlineOffset: "3px",
  },
  ".cm-lintRange-active": { backgroundColor: "transparent" },
  ".cm-gutter-lint .cm-lint-marker-error": {
    content: "normal",
    width: "9px",
    height: "9px",
    margin: "4px 2px",
    borderRadius: "50%",
    backgroundColor: "var(--over)",
  },
  ".cm-diagnostic-error": { borderLeftColor: "var(--over)" },
});

const highlight = HighlightStyle.define([
  { tag: [tags.keyword, tags.modifier, tags.self], color: "var(--code-keyword)" },
  { tag: [tags.string, tags.special(tags.string), tags.regexp], color: "var(--code-string)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--code-number)" },
  { tag: tags.comment, color: "var(--faint)", fontStyle: "italic" },
  {
    tag: [tags.function(tags.variableName), tags.function(tags.propertyName)],
    color: "var(--code-call)",
  },
  { tag: tags.definition(tags.variableName), fontWeight: "600" },
  { tag: tags.invalid, color: "var(--over)" },
]);

export const codeTheme: Extension = [theme, syntaxHighlighting(highlight)];
