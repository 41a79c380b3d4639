/** The files of a map: itself, and the tilesets and templates that it refers to, each read once. */
import { messageOf } from "../error.js";
import { isRecord, type Json, type JsonRecord, type Report } from "./values.js";

/** A file's content; bytes are taken as UTF-8. */
export type FileContent = string | Uint8Array | ArrayBuffer;

/**
 * Gives the files that a map refers to. `path` is relative to the map's own folder, with "/" and
 * no "." in it: "templates/block.tx", "../tiles/ground.tsx". Paths that are absolute, or name a
 * host, are refused before. Null, or anything thrown, means that there is no such file.
 */
export type FileOpener = (path: string) => Promise<FileContent | null> | FileContent | null;

interface Document {
  json: JsonRecord | null;
  reported: boolean;
  trouble: string;
}

/** Reads .tmj, .tsj, .tj or their XML forms; throws if it is neither. */
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

/** What `source` in the file `from` is called from the map's folder; null if that is nowhere. */
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

export class Library {
  readonly #open: FileOpener | undefined;
  readonly #documents = new Map<string, Document>();

  constructor(open: FileOpener | undefined) {
    this.#open = open;
  }

  /** Reads all that a map may come to need. */
  async prepare(map: JsonRecord): Promise<void> {
    for (const tileset of listOf(map.tilesets)) await this.#load("", tileset.source);
    await this.#prepareLayers(map, 0);
  }

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

  /** The path of what was loaded, now or before. */
  async #load(from: string, source: Json): Promise<string | null> {
    const path = typeof source === "string" ? join(from, source) : null;
    if (path === null || this.#documents.has(path)) return path;
    const document: Document = { json: null, reported: false, trouble: "" };
    this.#documents.set(path, document);
    let content: FileContent | null = null;
    try {
      content = (await this.#open?.(path)) ?? null;
    } catch {
      // As if it were not there.
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

  /** What was reported will be again: before a map is read anew. */
  forgetReports(): void {
    for (const document of this.#documents.values()) document.reported = false;
  }

  /** What `source` in the file `from` means, of what was prepared; null after one report. */
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

function listOf(json: Json): JsonRecord[] {
  return Array.isArray(json) ? json.filter(isRecord) : [];
}
