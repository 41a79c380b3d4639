/**
 * Loads and parses the files of a map: the map, and the tilesets and templates that it refers to.
 */
import { messageOf } from "../error.js";
import { isRecord, type Json, type JsonRecord, type Report } from "./values.js";

/** The content of a file; bytes are UTF-8. */
export type FileContent = string | Uint8Array | ArrayBuffer;

/**
 * Returns the content of a file that a map refers to. `path` is relative to the map's folder, with
 * "/" between its parts and no part ".": "templates/block.tx", "../tiles/ground.tsx". It is not
 * called for absolute paths and addresses. Null or an exception means that the file does not exist.
 */
export type FileOpener = (path: string) => Promise<FileContent | null> | FileContent | null;

/** A file that was loaded. */
interface Document {
  /** Its content, null where it cannot be used. */
  json: JsonRecord | null;
  /** Whether the problem is in the report. */
  reported: boolean;
  /** Why it cannot be used. */
  trouble: string;
}

/** Parses JSON (.tmj, .tsj, .tj), or XML into the same JSON. Throws an Error for other content. */
export async function parseDocument(content: FileContent): Promise<Json> {
  const raw = typeof content === "string" ? content : new TextDecoder().decode(content);
  const text = raw.replace(/^\uFEFF/, "");
  if (/^[ \t\r\n]*</.test(text)) {
    const { parseTmx } = await import("./tmx.js");
    try {
      return await parseTmx(text.trimStart());
    } catch (error) {
      throw new Error(`this XML cannot be read: ${messageOf(error).split("\n")[0]}`);
    }
  }
  try {
    return JSON.parse(text) as Json;
  } catch (error) {
    throw new Error(`this is neither JSON nor XML: not JSON: ${messageOf(error)}`);
  }
}

/**
 * The path, from the map's folder, of the path `source` in the file `from`; null for an absolute
 * path, an address, or the folder itself.
 */
function join(from: string, source: string): string | null {
  if (/^[/\\]/.test(source) || source.includes(":")) return null;
  const parts = from.includes("/") ? from.slice(0, from.lastIndexOf("/")).split("/") : [];
  for (const part of source.split(/[/\\]/)) {
    if (part === "" || part === ".") continue;
    const last = parts[parts.length - 1];
    if (part === ".." && last !== undefined && last !== "..") parts.pop();
    else parts.push(part);
  }
  return parts.length > 0 ? parts.join("/") : null;
}

/** The tilesets and templates of a map; each file is loaded once. */
export class Library {
  readonly #open: FileOpener | undefined;
  readonly #documents = new Map<string, Document>();

  constructor(open: FileOpener | undefined) {
    this.#open = open;
  }

  /** Loads all files to which the map refers, also through templates. */
  async prepare(map: JsonRecord): Promise<void> {
    for (const tileset of listOf(map.tilesets)) await this.#load("", tileset.source);
    await this.#prepareLayers(map, 0);
  }

  /** Loads the templates of objects in all layers and groups, to 64 levels of groups. */
  async #prepareLayers(parent: JsonRecord, depth: number): Promise<void> {
    if (depth > 64) return;
    for (const layer of listOf(parent.layers)) {
      for (const { template } of listOf(layer.objects)) {
        const path = await this.#load("", template);
        const tileset = path === null ? undefined : this.#documents.get(path)?.json?.tileset;
        if (path !== null && isRecord(tileset)) await this.#load(path, tileset.source);
      }
      await this.#prepareLayers(layer, depth + 1);
    }
  }

  /** Loads a file unless it was loaded before. Returns its path, null where `source` has none. */
  async #load(from: string, source: Json): Promise<string | null> {
    const path = typeof source === "string" ? join(from, source) : null;
    if (path === null || this.#documents.has(path)) return path;
    const document: Document = { json: null, reported: false, trouble: "" };
    this.#documents.set(path, document);
    let content: FileContent | null = null;
    try {
      content = (await this.#open?.(path)) ?? null;
    } catch {
      // The same as a file that does not exist.
    }
    if (content === null) {
      document.trouble = "it is not there, or cannot be read";
      return path;
    }
    try {
      const json = await parseDocument(content);
      document.json = isRecord(json) ? json : {};
    } catch (error) {
      document.trouble = messageOf(error);
    }
    return path;
  }

  /** Lets problems be reported again, before the map is read a second time. */
  forgetReports(): void {
    for (const document of this.#documents.values()) document.reported = false;
  }

  /**
   * The content of the file `source`, as it is named in the file `from`, among those that `prepare`
   * loaded; null, with one problem in the report, where it cannot be used.
   */
  open(
    report: Report,
    from: string,
    source: Json,
    type: "tileset" | "template",
  ): { json: JsonRecord; path: string } | null {
    const name = typeof source === "string" ? source : "";
    const path = join(from, name);
    if (path === null) {
      const rule = "only files by a path from the map's folder are read";
      report.add("skip", 0, `${type} '${name}': ${rule}`);
      return null;
    }
    const document = this.#documents.get(path);
    if (document?.json && document.json.type === type) return { json: document.json, path };
    if (document?.json) report.add("skip", 0, `'${path}' is no ${type}`);
    else if (document && !document.reported) {
      document.reported = true;
      report.add("skip", 0, `${type} '${path}': ${document.trouble}`);
    }
    return null;
  }
}

/** The objects in a list; an empty list for anything else. */
function listOf(json: Json): JsonRecord[] {
  return Array.isArray(json) ? json.filter(isRecord) : [];
}
