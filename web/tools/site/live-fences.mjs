/**
 * A plugin of markdown-it: code fenced as "js live" becomes a <Live>, in which the reader runs and
 * changes it. `view=X,Y,WIDTH` says which part of the world its picture shows: the middle, and how
 * many units of length it is wide. With `auto` it runs by itself.
 */
const LIVE = /^js live(?: view=(\S+))?( auto)?$/;

/** Escapes text for an attribute of a Vue template. */
function attribute(text) {
  return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
}

export function liveFences(md) {
  const { fence } = md.renderer.rules;
  md.renderer.rules.fence = (tokens, at, options, env, self) => {
    const token = tokens[at];
    const live = LIVE.exec(token.info.trim());
    if (live) token.info = "js";
    const shown = fence(tokens, at, options, env, self);
    if (!live) return shown;
    const view = live[1] ? ` view="${attribute(live[1])}"` : "";
    return `<Live code="${attribute(token.content.trimEnd())}"${view}${live[2] ?? ""}>${shown}</Live>`;
  };
}
