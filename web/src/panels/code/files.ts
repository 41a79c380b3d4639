/** The files of a scene: its own, and what it imports from beside it. */

/** Paths are relative to the page: "scenes/artillery.js". */
export interface SourceFile {
  path: string;
  text: string;
}

const fetched = new Map<string, Promise<string>>();

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

/** What a text imports, with what that imports, each once; what is not there is left out. */
export async function importsOf(path: string, text: string): Promise<SourceFile[]> {
  const found = new Map<string, SourceFile>([[path, { path, text }]]);
  for (const file of found.values())
    for (const next of pathsIn(file)) {
      if (found.has(next)) continue;
      const source = await readSource(next).catch(() => null);
      if (source !== null) found.set(next, { path: next, text: source });
    }
  found.delete(path);
  return [...found.values()];
}

/** Only files of the scenes: nothing else of the page is for reading here. */
function pathsIn({ path, text }: SourceFile): string[] {
  const base = new URL(path, document.baseURI);
  const root = new URL("../", document.baseURI).href;
  return [...text.matchAll(/\b(?:from|import)\s*["'](\.{1,2}\/[^"'\n]+)["']/g)]
    .map(([, relative]) => new URL(relative, base).href)
    .filter((address) => address.startsWith(`${root}scenes/`))
    .map((address) => address.slice(root.length));
}
