/** The pages of the site for other languages, made of the READMEs of bindings, whose programs are tested there. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const BINDINGS = { cpp: "C++", lua: "LuaJIT", rust: "Rust" };

/** A link of the repository: to the headers it leads to the reference, any other is left as its words. */
const linkOf = (words, path) =>
  path.endsWith("engine/include/thud") ? `[${words}](./reference-c.md)` : words;

/** The pages as [name, text in Markdown]. */
export function bindingPages() {
  return Object.entries(BINDINGS).map(([folder, language]) => {
    const file = fileURLToPath(new URL(`../../../bindings/${folder}/README.md`, import.meta.url));
    const text = readFileSync(file, "utf8")
      .replace(/^# .*/, `# Begin in ${language}`)
      .replace(/\[([^\]]+)\]\((?!https?:|#)([^)]+)\)/g, (_, words, path) => linkOf(words, path));
    return [`binding-${folder}`, text];
  });
}
