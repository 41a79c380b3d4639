/** The commit that the working tree is at, which pictures in docs/ belong to. */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
/** All that the page is made of. */
const SOURCES = ["assets", "demo", "engine", "web", ":(exclude)*.md"];

const git = (...words) => execFileSync("git", ["-C", ROOT, ...words], { encoding: "utf8" }).trim();

/** Twelve digits; throws where there is no repository, or where what the page is made of has changed. */
export function cleanCommit() {
  const changed = git("status", "--porcelain", "--untracked-files=no", "--", ...SOURCES);
  if (changed !== "") throw new Error(`pictures are of a commit; not committed yet:\n${changed}`);
  return git("rev-parse", "HEAD").slice(0, 12);
}
