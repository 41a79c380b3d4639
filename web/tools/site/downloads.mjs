#!/usr/bin/env node
/** Writes what the site offers for download: the engine as one file in C, and the npm package, in dist/docs/files. */
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync } from "node:fs";
import { fileURLToPath } from "node:url";

const path = (name) => fileURLToPath(new URL(`../../../${name}`, import.meta.url));
const files = path("web/dist/docs/files");

rmSync(files, { recursive: true, force: true });
mkdirSync(files);
execFileSync("python3", [path("tools/amalgamate.py"), files], { stdio: "inherit" });
execFileSync("npm", ["pack", "--silent", "--pack-destination", files], { cwd: path("web/package"), stdio: "inherit" });
