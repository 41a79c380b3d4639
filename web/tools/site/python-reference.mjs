/** The page of the reference in Python, made of the sources of bindings/python/thud. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { escaped, proseOf } from "./prose.mjs";

const FILES = ["_world.py", "_batch.py"].map((name) =>
  fileURLToPath(new URL(`../../../bindings/python/thud/${name}`, import.meta.url)),
);

/** A class, or a public method of one, with its comment. `indent`: the spaces before it. */
const entryOf = (indent, word) =>
  new RegExp(
    `((?:^ {${indent}}@\\w[\\w.]*\\n)*)^ {${indent}}${word} (${word === "def" ? "(?!_)" : ""}\\w+)((?:.|\\n(?! {0,${indent}}\\S))*?):\\n+` +
      `(?: {${indent + 4}}"""((?:.|\\n)*?)""")?`,
    "gm",
  );

/** A signature in one line, its types without the quotes of types that are declared later. */
const typed = (text) => text.replace(/\s+/g, " ").replace(/(: |-> )"([^"]+)"/g, "$1$2");

const plain = (comment = "") => comment.replace(/^ {4,8}/gm, "").trim();

/** The page as [[name, text in Markdown]]. */
export function pythonPages() {
  const text = FILES.map((file) => readFileSync(file, "utf8")).join("\n");
  const parts = text.split(/^(?=class )/m).filter((part) => part.startsWith("class "));
  const classes = parts.map((part) => {
    const [[, , name, bases, comment]] = [...part.matchAll(entryOf(0, "class"))];
    const init = /def __init__\(self, ?((?:.|\n)*?)\):/.exec(part)?.[1] ?? "";
    const head = `${name}${init ? `(${typed(init)})` : bases}`;
    const title = name === "_Object" ? "What bodies, shapes and joints share" : name;
    const methods = [...part.matchAll(entryOf(4, "def"))]
      .filter(([, decorators]) => !decorators.includes("setter"))
      .map(([, decorators, method, rest, meaning]) => {
        const isProperty = decorators.includes("property");
        const given = typed(rest).replace(/\(self(?:, )?/, "(");
        const shown = isProperty ? `${method}${given.replace("() ->", ":")}` : `${method}${given}`;
        return `### ${method} {#${name}-${method}}\n\n<div v-pre class="item"><pre class="signature">${escaped(shown)}</pre>${proseOf(plain(meaning), escaped)}</div>\n`;
      });
    return `## ${title} {#${name}}\n\n<div v-pre class="item"><pre class="signature">class ${escaped(head)}</pre>${proseOf(plain(comment), escaped)}</div>\n\n${methods.join("\n")}`;
  });
  const intro =
    "The classes of `thud`. Their options are the fields of the engine's defs, by the names, ranges and " +
    "defaults of [the reference in C](./reference-c.md): `thud.World(**options)` those of " +
    "[thud_world_def](./c-thud.md#thud_world_def), `world.body` those of " +
    "[thud_body_def](./c-thud.md#thud_body_def), and shapes those of " +
    "[thud_shape_def](./c-thud.md#thud_shape_def). The whole interface in C is in `thud.lib` and `thud.ffi`.";
  return [["python-thud", `# The package thud\n\n${intro}\n\n${classes.join("\n")}`]];
}
