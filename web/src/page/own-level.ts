/**
 * A level of the visitor's own: of files or a folder, the map and what it refers to. Loaded when
 * the first is brought.
 */
import { type Level, readLevel } from "thud/level";
import { messageOf } from "../shared/error";

/** Larger files are no maps, and more than that no folder of maps. */
const LARGEST_FILE = 2 ** 26;
const MOST_FILES = 5000;

/** As a visitor brings it: by a button, or by dropping. */
export type Brought = File | FileSystemEntry;

export interface OwnLevel {
  name: string;
  /** Texts: the map's is "own.tmj", of the others "own/" and the path from the map's folder. */
  files: Record<string, string>;
  /** Other maps that were there. */
  others: string[];
}

interface Found {
  path: string;
  file: File;
}

/** What was brought as a level; throws if there is none. */
export async function findLevel(brought: readonly Brought[]): Promise<OwnLevel> {
  const found: Found[] = [];
  for (const one of brought) await list(one, found);
  const [map, ...others] = mapsOf(found);
  if (!map) throw new Error("There is no map of the Tiled editor among these files (.tmx, .tmj).");
  const files: Record<string, string> = { "own.tmj": await textOf(map) };
  const open = async (path: string) => {
    const one = pick(found, map, path);
    return one ? (files[`own/${path}`] = await textOf(one)) : null;
  };
  // The reader asks for what the map refers to; what it makes of it is told when the level runs.
  await readLevel("own", files["own.tmj"], { skip: true, open }).catch((): Level | null => null);
  const nameOf = ({ file }: Found) => file.name.replace(/\.[^.]*$/, "");
  return { name: nameOf(map), files, others: others.map(({ file }) => file.name) };
}

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
      // A folder is told in parts.
      const part = await new Promise<FileSystemEntry[]>((resolve, reject) =>
        reader.readEntries(resolve, reject),
      );
      if (part.length === 0) return;
      for (const entry of part) await list(entry, found);
    }
  }
}

/** Those nearest to the top of the folder first; a single file is taken for one. */
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

/** The file by its place, else, where files were chosen without their folders, by its name. */
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
