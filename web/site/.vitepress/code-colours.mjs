/** The colours of code, those of the page's editor (src/style/code.css). */

/** A theme for shiki, of the editor's colours. */
function themeOf(name, type, { ink, faint, ground, keyword, string, number, call }) {
  const rule = (scope, foreground, fontStyle) => ({ scope, settings: { foreground, fontStyle } });
  return {
    name,
    type,
    colors: { "editor.foreground": ink, "editor.background": ground },
    settings: [
      { settings: { foreground: ink, background: ground } },
      rule(["comment", "punctuation.definition.comment"], faint, "italic"),
      rule(["keyword", "storage", "keyword.operator.new", "keyword.control"], keyword),
      rule(["keyword.operator"], ink),
      rule(["string", "punctuation.definition.string"], string),
      rule(["constant.numeric", "constant.language"], number),
      rule(["entity.name.function", "support.function"], call),
    ],
  };
}

export const dark = themeOf("thud-dark", "dark", {
  ink: "#e8edf6",
  faint: "#9aa8c0",
  ground: "#0f1521",
  keyword: "#ff9d76",
  string: "#a5d6a0",
  number: "#f2c26b",
  call: "#7cc7f0",
});

export const light = themeOf("thud-light", "light", {
  ink: "#1b2230",
  faint: "#566379",
  ground: "#fbfbfc",
  keyword: "#a93a17",
  string: "#2b6a2b",
  number: "#855300",
  call: "#1a5d94",
});
