/**
 * An HTTP server for the files of one folder, with compression and the headers of headers.mjs, and for
 * rooms in which browsers meet (rooms.mjs).
 */
import { createHash } from "node:crypto";
import { readFile, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, resolve, sep } from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";
import { ISOLATION, WORKER_POLICY } from "./headers.mjs";
import { createRooms } from "./rooms.mjs";

/** Content types by the extension of files. */
const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".csv": "text/csv; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".map": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".tmj": "application/json",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/** The encodings, the best first, and the functions that compress. */
const ENCODERS = {
  // The highest quality would take half a second for the engine, and save a twentieth of its size.
  br: (bytes) =>
    promisify(brotliCompress)(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 6 } }),
  gzip: promisify(gzip),
};

/** The server of a folder. `under`: the path of the folder in URLs, with a slash at both ends. */
export function createStaticServer(folder, under = "/") {
  const root = resolve(folder);
  const files = new Map();
  const rooms = createRooms();
  return createServer((request, response) => {
    const path = (request.url ?? "").replace(/[?#].*$/, "");
    if (path.startsWith(under) && rooms(path.slice(under.length), request, response)) return;
    answer(root, under, files, request, response).catch(() =>
      refuse(response, 500, "Internal error"),
    );
  });
}

/** Answers one request. */
async function answer(root, under, files, request, response) {
  if (request.method !== "GET" && request.method !== "HEAD") {
    response.setHeader("Allow", "GET, HEAD");
    return refuse(response, 405, "Only GET and HEAD");
  }
  const path = fileOf(root, under, request.url ?? "/");
  const file = path && (await readKept(files, path));
  if (!file) return refuse(response, 404, "Not found");
  const type = TYPES[extname(path)] ?? "application/octet-stream";
  const headers = {
    ...ISOLATION,
    "Content-Type": type,
    ETag: file.tag,
    Vary: "Accept-Encoding",
    // The browser must not mix files of two builds: it asks each time, and gets 304 where the file
    // is the same.
    "Cache-Control": "no-cache",
    "X-Content-Type-Options": "nosniff",
  };
  if (type.startsWith("text/javascript")) headers["Content-Security-Policy"] = WORKER_POLICY;
  if (request.headers["if-none-match"] === file.tag) {
    response.writeHead(304, headers);
    return response.end();
  }
  const encoding = type === TYPES[".png"] ? null : encodingOf(request);
  if (encoding) headers["Content-Encoding"] = encoding;
  const bytes = await encoded(file, encoding);
  response.writeHead(200, { ...headers, "Content-Length": bytes.length });
  response.end(request.method === "HEAD" ? undefined : bytes);
}

/**
 * The file at a path; null where there is none. Files are kept in memory, with their compressed
 * forms, until they change on the disk.
 */
async function readKept(files, path) {
  const info = await stat(path).catch(() => null);
  if (!info?.isFile()) return null;
  const kept = files.get(path);
  if (kept?.changed === info.mtimeMs && kept.bytes.length === info.size) return kept;
  const bytes = await readFile(path);
  const tag = `"${createHash("sha256").update(bytes).digest("base64url").slice(0, 22)}"`;
  const file = { bytes, tag, changed: info.mtimeMs, encoded: {} };
  files.set(path, file);
  return file;
}

/** The best compression that the browser accepts; null: none. */
function encodingOf(request) {
  const accepted = (request.headers["accept-encoding"] ?? "").split(/[,;\s]+/);
  return Object.keys(ENCODERS).find((name) => accepted.includes(name)) ?? null;
}

/**
 * The bytes of a file in an encoding. The promise is kept, so that simultaneous requests compress
 * the file once.
 */
function encoded(file, encoding) {
  if (!encoding) return file.bytes;
  return (file.encoded[encoding] ??= ENCODERS[encoding](file.bytes));
}

/** The path of the file that a URL names; null where it is not below the root. */
function fileOf(root, under, url) {
  let path;
  try {
    path = decodeURIComponent(url.replace(/[?#].*$/, ""));
  } catch {
    return null;
  }
  if (path.includes("\0") || !path.startsWith(under)) return null;
  const rest = path.slice(under.length);
  const file = resolve(root, `./${rest}`);
  if (file !== root && !file.startsWith(root + sep)) return null;
  return rest === "" || rest.endsWith("/") ? join(file, "index.html") : file;
}

/** Answers with an error status; closes the connection where the headers have been sent. */
function refuse(response, status, text) {
  if (response.headersSent) return response.destroy();
  response.writeHead(status, { ...ISOLATION, "Content-Type": "text/plain; charset=utf-8" });
  response.end(`${text}\n`);
}
