/** Fetches the source files of a scene: its module, the files of the scenes that it imports, and for
 * a game of examples/games the same game in C. */

export interface SourceFile {
  /** Relative to the page: "scenes/artillery.js". */
  path: string;
  text: string;
}

/** Texts by path, each fetched once; failures are forgotten. */
const fetched = new Map<string, Promise<string>>();

/** The text of a file, with \n at the ends of its lines; rejects if it cannot be fetched. */
export function readSource(path: string): Promise<string> {
  let text = fetched.get(path);
  if (!text) {
    text = load(path);
    fetched.set(path, text);
    text.catch(() => fetched.delete(path));
  }
  return text;
}

async function load(path: string): Promise<string> {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path} cannot be loaded: ${response.status}`);
  return (await response.text()).replace(/\r\n?/g, "\n");
}

/** The files that a text at `path` imports, directly or through other files, each once, and a game's
 * file in C. Files that cannot be fetched are left out. */
export async function importsOf(path: string, text: string): Promise<SourceFile[]> {
  const found = new Map<string, SourceFile>([[path, { path, text }]]);
  for (const file of found.values())
    for (const next of pathsIn(file)) {
      if (found.has(next)) continue;
      const source = await readSource(next).catch(() => null);
      if (source !== null) found.set(next, { path: next, text: source });
    }
  found.delete(path);
  if (path.startsWith("scenes/game_")) {
    const inC = path.replace(/js$/, "c");
    const text = await readSource(inC).catch(() => null);
    if (text !== null) found.set(inC, { path: inC, text });
  }
  return [...found.values()];
}

/** The paths that a file imports, as found by a pattern in its text. Only files in the folder
 * "scenes" count; others are not shown to the visitor. */
function pathsIn({ path, text }: SourceFile): string[] {
  const base = new URL(path, document.baseURI);
  const root = new URL("../", document.baseURI).href;
  return [...text.matchAll(/\b(?:from|import)\s*["'](\.{1,2}\/[^"'\n]+)["']/g)]
    .map(([, relative]) => new URL(relative, base).href)
    .filter((address) => address.startsWith(`${root}scenes/`))
    .map((address) => address.slice(root.length));
}
