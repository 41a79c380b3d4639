/**
 * Finds the commit of the working tree, which docs/pictures/pictures.json names for each picture.
 */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
/** The files from which the page is built, as git pathspecs. */
const SOURCES = ["assets", "demo", "engine", "web", ":(exclude)*.md"];

const git = (...words) => execFileSync("git", ["-C", ROOT, ...words], { encoding: "utf8" }).trim();

/**
 * The first twelve digits of the commit. Throws where there is no repository, or where SOURCES have
 * changes that are not committed.
 */
export function cleanCommit() {
  const changed = git("status", "--porcelain", "--untracked-files=no", "--", ...SOURCES);
  if (changed !== "") throw new Error(`pictures are of a commit; not committed yet:\n${changed}`);
  return git("rev-parse", "HEAD").slice(0, 12);
}
