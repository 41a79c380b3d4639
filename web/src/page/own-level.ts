/**
 * Reads a level from the visitor's files or folder: finds the map of the Tiled editor among them
 * and collects the files that it refers to. Imported when the first level is opened.
 */
import { type Level, readLevel } from "thud/level";
import { messageOf } from "../shared/error";

/**
 * Maximum size in bytes of a file that is read, and maximum number of files. Chosen far above those
 * of maps.
 */
const LARGEST_FILE = 2 ** 26;
const MOST_FILES = 5000;

/** A file chosen with the button, or the file-system entry of a file or folder that was dropped. */
export type Brought = File | FileSystemEntry;

export interface OwnLevel {
  /** The map's file name without its ending. */
  name: string;
  /** Texts by name: "own.tmj" is the map, "own/PATH" a file by its path from the map's folder. */
  files: Record<string, string>;
  /** File names of further maps that were found, which are not run. */
  others: string[];
}

interface Found {
  path: string;
  file: File;
}

/** The level in the visitor's files; throws if there is no map, or a file is too large or
 * unreadable. */
export async function findLevel(brought: readonly Brought[]): Promise<OwnLevel> {
  const found: Found[] = [];
  for (const one of brought) await list(one, found);
  const [map, ...others] = mapsOf(found);
  if (!map) throw new Error(`There is no map of the Tiled editor (.tmx, .tmj) ${amongWhich(found)}.`);
  const files: Record<string, string> = { "own.tmj": await textOf(map) };
  const open = async (path: string) => {
    const one = pick(found, map, path);
    return one ? (files[`own/${path}`] = await textOf(one)) : null;
  };
  // `readLevel` opens every file that the map refers to. Its result and errors are ignored: the
  // worker reads the level again when it runs, and reports them.
  await readLevel("own", files["own.tmj"], { skip: true, open }).catch((): Level | null => null);
  const nameOf = ({ file }: Found) => file.name.replace(/\.[^.]*$/, "");
  return { name: nameOf(map), files, others: others.map(({ file }) => file.name) };
}

/**
 * Words for the error message that no map was found: among which files. If the folder has more
 * files than are read, they advise to open the map's own folder.
 */
function amongWhich(found: readonly Found[]): string {
  if (found.length < MOST_FILES) return "among these files";
  return `among the first ${MOST_FILES.toLocaleString("en")} files: open the map’s own folder`;
}

/** Appends a file, or all files of a folder and its subfolders, to `found`. */
async function list(one: Brought, found: Found[]): Promise<void> {
  if (found.length >= MOST_FILES) return;
  if (one instanceof File) {
    found.push({ path: one.webkitRelativePath || one.name, file: one });
  } else if (one.isFile) {
    const entry = one as FileSystemFileEntry;
    const file = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
    found.push({ path: one.fullPath.replace(/^\//, ""), file });
  } else {
    const reader = (one as FileSystemDirectoryEntry).createReader();
    for (;;) {
      // readEntries lists a folder in parts; an empty one is the end.
      const part = await new Promise<FileSystemEntry[]>((resolve, reject) =>
        reader.readEntries(resolve, reject),
      );
      if (part.length === 0) return;
      for (const entry of part) await list(entry, found);
    }
  }
}

/** The maps among files, those nearest to the top folder first. Without a .tmj or .tmx, a single
 * file is taken for a map, or the first .json or .xml of several. */
function mapsOf(found: readonly Found[]): Found[] {
  const named = (pattern: RegExp) => found.filter(({ path }) => pattern.test(path));
  const maps = named(/\.tm[jx]$/i);
  const depth = ({ path }: Found) => path.split("/").length;
  if (maps.length > 0)
    return maps.sort((a, b) => depth(a) - depth(b) || a.path.localeCompare(b.path));
  return found.length === 1 ? [...found] : named(/\.(json|xml)$/i).slice(0, 1);
}

async function textOf({ path, file }: Found): Promise<string> {
  if (file.size > LARGEST_FILE) throw new Error(`“${path}” is too large for a map.`);
  try {
    return await file.text();
  } catch (error) {
    throw new Error(`“${path}” cannot be read: ${messageOf(error)}`);
  }
}

/** The file at a path relative to the map's folder; else, since files may be chosen without their
 * folders, one of the same name. */
function pick(found: readonly Found[], map: Found, path: string): Found | undefined {
  const parts = map.path.split("/").slice(0, -1);
  for (const part of path.split("/")) {
    if (part === "..") parts.pop();
    else parts.push(part);
  }
  const wanted = parts.join("/");
  const name = path.slice(path.lastIndexOf("/") + 1);
  return (
    found.find((one) => one.path === wanted) ?? found.find(({ file }) => file.name === name)
  );
}
