/** A plugin of Vite that ends a build by writing dist/sw.js, which knows the build's files. */
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { ISOLATION, WORKER_POLICY } from "./headers.mjs";

const ENTRY = fileURLToPath(new URL("../src/offline/sw.ts", import.meta.url));

/** Which list of the service worker's `BUILD` a file belongs to, by its path; null is for none. */
function listOf(url) {
  if (url === "sw.js" || url.endsWith(".map")) return null;
  if (/^assets\/thud-(first|rest)-[\w-]{8}\.wasm$/.test(url)) return "simd";
  // The package's default, the same engine in one file, which the page never asks for.
  if (/^assets\/thud-[\w-]{8}\.wasm$/.test(url)) return null;
  if (/^assets\/(thud-scalar|Box2D\.compat)-[\w-]{8}\.(wasm|js)$/.test(url)) return "scalar";
  return /^assets\/Box2D\.deluxe-/.test(url) ? "simd" : "files";
}

function filesOf(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesOf(path) : [path];
  });
}

export function offline() {
  return {
    name: "thud-offline",
    apply: "build",
    writeBundle: ({ dir }) => writeServiceWorker(dir),
  };
}

/** Writes sw.js for the files that a built folder has now, and the policy of its workers. */
export async function writeServiceWorker(dir, scriptPolicy = WORKER_POLICY) {
  const lists = { files: [], simd: [], scalar: [] };
  const version = createHash("sha256").update(JSON.stringify([ISOLATION, scriptPolicy]));
  for (const path of filesOf(dir).sort()) {
    const url = relative(dir, path).split(sep).join("/");
    const list = listOf(url);
    if (!list) continue;
    const hash = createHash("sha256").update(readFileSync(path)).digest("base64");
    version.update(`${url} ${hash}\n`);
    lists[list].push({ url, integrity: `sha256-${hash}` });
  }
  const BUILD = {
    version: version.digest("hex").slice(0, 16),
    ...lists,
    headers: ISOLATION,
    scriptPolicy,
  };
  writeFileSync(join(dir, "sw.js"), await bundle(BUILD));
}

/** One classic script: browsers know those as service workers longer than modules. */
async function bundle(BUILD) {
  const [{ output }] = await build({
    configFile: false,
    logLevel: "warn",
    publicDir: false,
    define: { BUILD: JSON.stringify(BUILD) },
    build: {
      write: false,
      target: "es2022",
      lib: { entry: ENTRY, formats: ["iife"], name: "thudOffline" },
    },
  });
  return output[0].code;
}
