/** Comments of sources as HTML. */

export function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

/** A text in one line, with links, and with what stands in backquotes as code. */
function lineOf(text, link) {
  return link(text.replace(/\s+/g, " ").trim()).replace(/`([^`]+)`/g, "<code>$1</code>");
}

/** A paragraph whose lines begin with "- ". */
function listOf(text, link) {
  const items = text.split(/^- /m).slice(1);
  return `<ul>${items.map((item) => `<li>${lineOf(item, link)}</li>`).join("")}</ul>`;
}

/**
 * A comment: paragraphs, lists, and code, which is indented by four. `link` escapes a text and makes
 * links of the names in it.
 */
export function proseOf(comment, link) {
  const parts = [];
  for (const block of comment.split(/\n\s*\n/).filter((text) => text.trim()))
    if (/^ {4}/.test(block)) parts.push(`<pre class="signature verbatim" tabindex="0">${link(block.replace(/^ {4}/gm, ""))}</pre>`);
    else {
      const [plain, ...items] = block.split(/^(?=- )/m);
      const text = plain.startsWith("- ") ? "" : plain;
      const list = (text ? items : [plain, ...items]).join("");
      if (text.trim()) parts.push(`<p>${lineOf(text, link)}</p>`);
      if (list) parts.push(listOf(list, link));
    }
  return parts.join("");
}
