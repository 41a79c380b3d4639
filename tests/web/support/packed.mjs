/**
 * Packs the npm package, installs it into a new project, bundles it, runs it in Node or a browser,
 * and returns the state that it computes.
 */
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, extname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch } from "../../../web/tools/browser.mjs";
import { listenFrom } from "../../../web/tools/serve.mjs";
import { ISOLATION } from "../../../web/tools/headers.mjs";
import { PATIENCE } from "./page.mjs";
import { root } from "./package.mjs";

/** The content security policy for a page with the package: what the package needs and no more. */
export const POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self'; " +
  "img-src data:";

/**
 * The program for every host: a ball falls onto a box; returns what the package tells of the world.
 */
const RUN = `import { load, ThudError } from "thud";
import { buildLevel, readLevel } from "thud/level";

export async function run(source) {
  const thud = await load(source);
  const world = thud.createWorld();
  const ground = world.createBody();
  world.createObb(ground, { halfWidth: 4, halfHeight: 1, angle: 0.1 });
  const ball = world.createBody({ kind: "dynamic", position: [0.25, 3] });
  world.createCircle(ball, { radius: 0.5, restitution: 0.25 });
  for (let i = 0; i < 60; i++) world.step();
  const level = buildLevel(thud, await readLevel("empty", LEVEL));
  const told = { hash: world.hash(), height: world.positionOf(ball)[1], bodies: level.stats().bodies };
  if (!(ThudError.prototype instanceof Error)) throw new Error("no ThudError");
  level.close();
  world.close();
  return { ...told, shared: await share(startsNoWorker() ? 1 : 2) };
}

/**
 * Whether this is a worker of Firefox. There a worker that starts workers soon stands still for
 * ever, whatever they do, but only while a program drives the browser, as here.
 */
function startsNoWorker() {
  return !("document" in globalThis) && /Firefox/.test(globalThis.navigator?.userAgent);
}

/** A pile that is large enough for threads to share its steps, with and without threads. */
async function share(count) {
  const engines = [await load(), await load({ threads: count })];
  const piles = engines.map((engine) => {
    // A pile that sleeps would leave the threads nothing to do.
    const world = engine.createWorld({ sleeping: false });
    world.createTerrain(world.createBody(), { kind: "flat" });
    for (let i = 0; i < 2500; i++) {
      const box = world.createBody({ kind: "dynamic", position: [i % 50, 0.5 + Math.floor(i / 50)] });
      world.createObb(box, { halfWidth: 0.5, halfHeight: 0.5 });
    }
    for (let i = 0; i < 30; i++) world.step();
    return world;
  });
  const [alone, together] = piles.map((world) => world.hash());
  const { threads, exports } = engines[1];
  const helped = () => threads > 1 && exports.api_threads_helped() > 0;
  // On a busy machine a thread may come late.
  const end = Date.now() + 20_000;
  while (threads > 1 && !helped() && Date.now() < end) piles[1].step();
  const told = { threads, same: alone === together, helped: helped() };
  engines[1].endThreads();
  return told;
}

const LEVEL = JSON.stringify({
  type: "map",
  orientation: "orthogonal",
  width: 4,
  height: 4,
  tilewidth: 32,
  tileheight: 32,
  layers: [],
});
`;

/** The page's program runs it once in the page and once in a worker. */
const MAIN = `import { run } from "./run.js";

const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
const inWorker = new Promise((done) => {
  worker.onmessage = ({ data }) => done(data);
  worker.onerror = ({ message }) => done({ refused: message ?? "the worker does not start" });
});
const inPage = run().catch((error) => ({ refused: String(error) }));
globalThis.told = Promise.all([inPage, inWorker]);
`;

const WORKER = `import { run } from "./run.js";

run().then(postMessage, (error) => postMessage({ refused: String(error) }));
`;

const NODE = `import { run } from "./run.js";

run().then((told) => console.log(JSON.stringify(told)));
`;

const PAGE = `<!doctype html>
<meta charset="utf-8" />
<link rel="icon" href="data:," />
<title>thud</title>
<script type="module" src="main.js"></script>
`;

/** A folder with the package installed from its tarball and with the programs above. */
export function makeProject() {
  const folder = mkdtempSync(join(tmpdir(), "thud-packed-"));
  const npm = (words, cwd) =>
    execFileSync("npm", words, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  const [{ filename, files }] = JSON.parse(
    npm(["pack", "--json", "--pack-destination", folder], `${root}web/package`),
  );
  write(folder, { "package.json": JSON.stringify({ name: "try", private: true, type: "module" }) });
  // The optional packages come from web/, because npm works offline here.
  npm(["install", "--offline", "--omit=optional", "--no-audit", "--no-fund", filename], folder);
  for (const name of ["fzstd", "@rgrove/parse-xml"])
    cpSync(`${root}web/node_modules/${name}`, join(folder, "node_modules", name), { recursive: true });
  write(folder, {
    "run.js": RUN,
    "main.js": MAIN,
    "worker.js": WORKER,
    "node.js": NODE,
    "index.html": PAGE,
  });
  return { folder, files: files.map(({ path }) => path), remove: () => rmSync(folder, { recursive: true }) };
}

export function write(folder, texts) {
  for (const [name, text] of Object.entries(texts)) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
}

/** Runs a command and returns the JSON that the program prints. */
export function tell(command, words, folder) {
  const { status, stdout, stderr, error } = spawnSync(command, words, { cwd: folder, encoding: "utf8" });
  if (status !== 0) throw new Error(`${command} ${words.join(" ")}: ${error ?? stderr.slice(-2000)}`);
  return JSON.parse(stdout);
}

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

/** Serves a folder, with the policy and `headers` on every file. */
export async function host(folder, policy = POLICY, headers = ISOLATION) {
  const server = createServer((request, response) => {
    const path = new URL(request.url, "http://any").pathname;
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {
      "Content-Type": TYPES[extname(file)] ?? "application/octet-stream",
      "Content-Security-Policy": policy,
      ...headers,
    });
    response.end(readFileSync(file));
  });
  const port = await listenFrom(server, 0);
  const close = () => {
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  return { url: `http://127.0.0.1:${port}/`, close };
}

/**
 * What page and worker tell in a browser where Node.js tells `expected`. No thread helps in
 * Firefox's worker; see startsNoWorker.
 */
export function expectedIn(browser, expected) {
  return [expected, browser === "firefox" ? { ...expected, shared: ALONE } : expected];
}

/** What is told of sharing where there are no threads. */
export const ALONE = { threads: 1, same: true, helped: false };

/** A browser that opens pages; `tell` returns a page's result and its errors. */
export async function openBrowser(name) {
  const browser = await launch(name, { webgl: false });
  return {
    async tell(url) {
      const page = await browser.newPage();
      page.setDefaultTimeout(PATIENCE);
      const troubles = [];
      page.on("pageerror", (error) => troubles.push(error.message));
      page.on("console", (message) => {
        if (["error", "warning"].includes(message.type())) troubles.push(message.text());
      });
      await page.goto(url);
      await page.waitForFunction(() => globalThis.told !== undefined).catch(() => {
        throw new Error(`the page says nothing: ${troubles.join("; ")}`);
      });
      const told = await page.evaluate(() => globalThis.told);
      await page.close();
      return { told, troubles };
    },
    close: () => browser.close(),
  };
}

/** The folder tests/web/bundlers, where the bundlers are installed. */
export const bundlers = fileURLToPath(new URL("../bundlers/", import.meta.url));
const require = createRequire(`${bundlers}package.json`);

export function bring(name) {
  return import(pathToFileURL(require.resolve(name)).href);
}

/** The code for a host in the table of the package's README. */
export function recipeOf(name) {
  const readme = readFileSync(`${root}web/package/README.md`, "utf8");
  const row = [...readme.matchAll(/^\| ([^|]+) \| (.+) \|$/gm)].find(([, who]) =>
    who.split(", ").includes(name),
  );
  if (!row) throw new Error(`the README has no row for ${name}`);
  return [...row[2].matchAll(/`([^`]+)`/g)].map(([, code]) => code);
}
