/**
 * A plugin of Vite that writes the service worker dist/sw.js at the end of a build, with a list of
 * the build's files and their hashes.
 */
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { ISOLATION, WORKER_POLICY } from "./headers.mjs";

const ENTRY = fileURLToPath(new URL("../src/offline/sw.ts", import.meta.url));

/** The list of the service worker's `BUILD` to which a file belongs; null: it is in none. */
function listOf(url) {
  if (url === "sw.js" || url.endsWith(".map")) return null;
  // What the host says of itself.
  if (url === "rooms.json") return null;
  // The site, of which a visitor of the page may want none.
  if (url.startsWith("docs/")) return null;
  if (/^assets\/thud-(first|rest|recorded)-[\w-]{8}\.wasm$/.test(url)) return "simd";
  // The engine in one file, the package's default, which the page never fetches, and the one with
  // threads, which it fetches where a visitor asks for them.
  if (/^assets\/(thud-(threads-)?[\w-]{8}\.wasm|thread-[\w-]{8}\.js)$/.test(url)) return null;
  if (/^assets\/(thud-scalar|Box2D\.compat)-[\w-]{8}\.(wasm|js)$/.test(url)) return "scalar";
  return /^assets\/Box2D\.deluxe-/.test(url) ? "simd" : "files";
}

/** The paths of all files in a folder. */
function filesOf(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesOf(path) : [path];
  });
}

/** The plugin. */
export function offline() {
  return {
    name: "thud-offline",
    apply: "build",
    writeBundle: ({ dir }) => writeServiceWorker(dir),
  };
}

/**
 * Writes sw.js for the files that are in a built folder. `scriptPolicy`: the policy of its workers.
 */
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

/**
 * The source of the service worker as one classic script: older browsers support no modules as
 * service workers.
 */
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
