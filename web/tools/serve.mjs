#!/usr/bin/env node
/** Serves the built page, web/dist, on 127.0.0.1, or on all addresses, until Ctrl-C. */
import { spawn } from "node:child_process";
import { stat } from "node:fs/promises";
import { networkInterfaces } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { createStaticServer } from "./static-server.mjs";

const USAGE = `usage: node serve.mjs [--port N] [--open] [--lan]

  --port N   the port to begin with, 8080 by default; a taken one is left for the next
  --open     open the page where there is a desktop
  --lan      serve the other devices of this network, too, such as phones
`;

const HOST = "127.0.0.1";
const EVERYBODY = "0.0.0.0";
/** The number of ports after the first that are tried. Chosen. */
const TRIES = 50;

/**
 * Listens on the first free port from `port` on, at the address `host`; resolves to that port. `say` is
 * called with a message for each port that is taken.
 */
export function listenFrom(server, port, say = () => {}, host = HOST) {
  return new Promise((done, fail) => {
    let candidate = port;
    server.on("error", (error) => {
      const taken = error.code === "EADDRINUSE" || error.code === "EACCES";
      if (!taken || candidate >= Math.min(65535, port + TRIES)) return fail(error);
      const why = error.code === "EACCES" ? "not allowed" : "taken";
      say(`Port ${candidate} is ${why}; trying ${candidate + 1}`);
      server.listen(++candidate, host);
    });
    server.on("listening", () => done(server.address().port));
    server.listen(candidate, host);
  });
}

function readArguments(args) {
  const options = { port: 8080, open: false, lan: false };
  for (let i = 0; i < args.length; i++) {
    if (args[i] === "--help" || args[i] === "-h") {
      process.stdout.write(USAGE);
      process.exit(0);
    }
    if (args[i] === "--open") options.open = true;
    else if (args[i] === "--lan") options.lan = true;
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

/** Opens the URL in the system's default browser; does nothing where that fails. */
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
  const { port, open, lan } = readArguments(process.argv.slice(2));
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
  const used = await listenFrom(server, port, console.log, lan ? EVERYBODY : HOST);
  const url = `http://${HOST}:${used}/`;
  console.log(`thud runs at ${url} (Ctrl-C ends it)`);
  const others = Object.values(networkInterfaces()).flat();
  for (const { family, internal, address } of lan ? others : [])
    if (family === "IPv4" && !internal)
      console.log(`Other devices in this network find it at http://${address}:${used}/`);
  if (open && hasDesktop()) openBrowser(url);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href)
  main().catch((error) => {
    process.stderr.write(`serve: ${error.message}\n`);
    process.exit(1);
  });
