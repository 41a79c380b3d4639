#!/usr/bin/env node
/** Serves the built page, web/dist, on 127.0.0.1 until Ctrl-C. */
import { spawn } from "node:child_process";
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, resolve, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const USAGE = `usage: node serve.mjs [--port N] [--open]

  --port N   the port to begin with, 8080 by default; a taken one is left for the next
  --open     open the page where there is a desktop
`;

const HOST = "127.0.0.1";
/** How many ports are tried. */
const TRIES = 50;

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".map": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".tmj": "application/json",
  ".wasm": "application/wasm",
};

/** A server of one folder: its files and nothing beside them. */
export function createStaticServer(folder) {
  const root = resolve(folder);
  return createServer((request, response) => {
    answer(root, request, response).catch(() => refuse(response, 500, "Internal error"));
  });
}

async function answer(root, request, response) {
  if (request.method !== "GET" && request.method !== "HEAD") {
    response.setHeader("Allow", "GET, HEAD");
    return refuse(response, 405, "Only GET and HEAD");
  }
  const path = fileOf(root, request.url ?? "/");
  const info = path && (await stat(path).catch(() => null));
  if (!info?.isFile()) return refuse(response, 404, "Not found");
  response.writeHead(200, {
    "Content-Type": TYPES[extname(path)] ?? "application/octet-stream",
    "Content-Length": info.size,
    // A rebuilt page must not meet files of the last build.
    "Cache-Control": "no-cache",
    "X-Content-Type-Options": "nosniff",
  });
  if (request.method === "HEAD") return response.end();
  createReadStream(path)
    .on("error", () => response.destroy())
    .pipe(response);
}

/** The file that a request means, or null if that would lie outside the folder. */
function fileOf(root, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, "http://localhost").pathname);
  } catch {
    return null;
  }
  if (path.includes("\0")) return null;
  const file = resolve(root, `.${sep}${path}`);
  if (file !== root && !file.startsWith(root + sep)) return null;
  return path.endsWith("/") ? join(file, "index.html") : file;
}

function refuse(response, status, text) {
  if (response.headersSent) return response.destroy();
  response.writeHead(status, { "Content-Type": "text/plain; charset=utf-8" });
  response.end(`${text}\n`);
}

/** Listens on the first free port from `port` on; resolves to that port. */
export function listenFrom(server, port, say = () => {}) {
  return new Promise((done, fail) => {
    let candidate = port;
    server.on("error", (error) => {
      const taken = error.code === "EADDRINUSE" || error.code === "EACCES";
      if (!taken || candidate >= Math.min(65535, port + TRIES)) return fail(error);
      const why = error.code === "EACCES" ? "not allowed" : "taken";
      say(`Port ${candidate} is ${why}; trying ${candidate + 1}`);
      server.listen(++candidate, HOST);
    });
    server.on("listening", () => done(server.address().port));
    server.listen(candidate, HOST);
  });
}

function readArguments(args) {
  const options = { port: 8080, open: false };
  for (let i = 0; i < args.length; i++) {
    if (args[i] === "--help" || args[i] === "-h") {
      process.stdout.write(USAGE);
      process.exit(0);
    }
    if (args[i] === "--open") options.open = true;
    else if (args[i] === "--port") {
      options.port = Number(args[++i]);
      if (!Number.isInteger(options.port) || options.port < 1 || options.port > 65535)
        misused("--port needs a number from 1 to 65535");
    } else misused(`unknown option '${args[i]}'`);
  }
  return options;
}

function misused(why) {
  process.stderr.write(`serve: ${why}\n${USAGE}`);
  process.exit(2);
}

function openBrowser(url) {
  const [command, ...args] =
    process.platform === "darwin"
      ? ["open"]
      : process.platform === "win32"
        ? ["cmd", "/c", "start", ""]
        : ["xdg-open"];
  spawn(command, [...args, url], { stdio: "ignore", detached: true }).on("error", () => {}).unref();
}

function hasDesktop() {
  if (process.platform !== "linux") return true;
  return Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);
}

async function main() {
  const { port, open } = readArguments(process.argv.slice(2));
  const folder = fileURLToPath(new URL("../dist", import.meta.url));
  if (!(await stat(join(folder, "index.html")).catch(() => null))) {
    process.stderr.write("serve: web/dist has no page; run `npm run build` in web/ first\n");
    process.exit(1);
  }
  const server = createStaticServer(folder);
  for (const signal of ["SIGINT", "SIGTERM"])
    process.on(signal, () => {
      server.closeAllConnections();
      server.close(() => process.exit(0));
    });
  const used = await listenFrom(server, port, console.log);
  const url = `http://${HOST}:${used}/`;
  console.log(`thud runs at ${url} (Ctrl-C ends it)`);
  if (open && hasDesktop()) openBrowser(url);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href)
  main().catch((error) => {
    process.stderr.write(`serve: ${error.message}\n`);
    process.exit(1);
  });
