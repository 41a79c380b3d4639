/**
 * Opens files of the visitor: a recording, or a level of the Tiled editor. A recording is
 * recognised by its first bytes, whatever its name is. Imported when the first file is opened.
 */
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { notice } from "./messages";
import { type Brought, findLevel } from "./own-level";

/** The scene that runs a level which the visitor has opened from a file. */
const OWN_LEVEL = "own_level";
/** The first bytes of a recording: TD_RECORDING_MAGIC in engine/src/recording/recording.h. */
const MAGIC = "thudrec\0";
/** The ending that the page gives to recordings. */
const ENDING = /\.rec$/i;

/**
 * Opens the recording or the level that is among these files and folders. If there is none, the
 * running scene goes on.
 */
export async function openBrought(app: App, brought: readonly Brought[]): Promise<void> {
  try {
    const recording = await findRecording(brought);
    if (recording) {
      const { openRecording } = await import("./recording");
      await openRecording(app, recording);
      return;
    }
    const { name, files, others } = await findLevel(brought);
    await app.open(OWN_LEVEL, { level: { name, files } });
    if (others.length > 0) notice(`This is “${name}”; also there: ${others.join(", ")}`, 20);
  } catch (error) {
    notice(messageOf(error), 20);
  }
}

/**
 * The first recording among the files; files in folders are not searched. Throws if a file has the
 * ending of a recording and is none.
 */
async function findRecording(brought: readonly Brought[]): Promise<File | null> {
  for (const one of brought) {
    const file = await fileOf(one);
    if (!file) continue;
    const first = await file.slice(0, MAGIC.length).text();
    if (first === MAGIC) return file;
    if (ENDING.test(file.name)) throw new Error(`“${file.name}” is no recording of thud.`);
  }
  return null;
}

/** The file of an entry; null for a folder. */
async function fileOf(one: Brought): Promise<File | null> {
  if (one instanceof File) return one;
  if (!one.isFile) return null;
  return new Promise((resolve, reject) => (one as FileSystemFileEntry).file(resolve, reject));
}
