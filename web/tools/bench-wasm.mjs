#!/usr/bin/env node
/**
 * Measures the step times of thud and of Box2D v3 (npm box2d3-wasm, its SIMD build) as WebAssembly,
 * in Node.js and in Chromium, and prints them as a table. wasm-race.mjs has the measurement itself.
 */
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { PLANS, race } from "./wasm-race.mjs";

const USAGE = `usage: node bench-wasm.mjs [OPTION...]

  --node, --chromium   only there; both without either
  --scene NAME[:SIZE]  only this scene; may be given several times
  --quick              few steps of small scenes: shows that it runs, compares little
  --json FILE          also writes the results to FILE

Wants thud.wasm built (./run demo or ./run test do that) and web/'s packages.
`;

const web = fileURLToPath(new URL("..", import.meta.url));
const require = createRequire(new URL("../package.json", import.meta.url));
/** The loader of Box2D's SIMD build in its package. */
const DELUXE = "build/dist/es/deluxe/Box2D.deluxe.mjs";

function fail(message) {
  process.stderr.write(`bench-wasm: ${message}\n\n${USAGE}`);
  process.exit(2);
}

function readArguments(words) {
  const options = { places: [], plans: [], quick: false, json: null };
  for (let i = 0; i < words.length; i++) {
    const word = words[i];
    if (word === "--help" || word === "-h") {
      process.stdout.write(USAGE);
      process.exit(0);
    } else if (word === "--node" || word === "--chromium") options.places.push(word.slice(2));
    else if (word === "--quick") options.quick = true;
    else if (word === "--json") options.json = words[++i] ?? fail("--json wants a file");
    else if (word === "--scene")
      options.plans.push(planOf(words[++i] ?? fail("--scene wants a name")));
    else fail(`unknown option '${word}'`);
  }
  if (options.places.length === 0) options.places = ["node", "chromium"];
  if (options.plans.length === 0) options.plans = PLANS;
  if (options.quick)
    options.plans = options.plans.map((plan) => ({
      ...plan,
      size: plan.scene === "pyramid" ? 10 : Math.min(plan.size, 200),
      warmUp: 2,
      steps: 16,
    }));
  return options;
}

/** The plan of a word NAME[:SIZE]; of another size it has the steps of the scene's first plan. */
function planOf(text) {
  const [scene, size] = text.split(":");
  const known = PLANS.filter((plan) => plan.scene === scene);
  const names = [...new Set(PLANS.map((plan) => plan.scene))];
  if (known.length === 0) fail(`no such scene '${scene}'; there are ${names.join(", ")}`);
  if (size === undefined) return known[0];
  if (!/^[1-9]\d{0,6}$/.test(size)) fail(`'${text}' has no size that a scene can have`);
  return known.find((plan) => plan.size === Number(size)) ?? { ...known[0], size: Number(size) };
}

/** The folder of the npm package box2d3-wasm, with a slash at its end. */
function box2dFolder() {
  try {
    return dirname(require.resolve("box2d3-wasm/utils/camera")).replace(/build.dist.es.utils$/, "");
  } catch {
    return `${web}node_modules/box2d3-wasm/`;
  }
}

/** A function that prints the share of a plan that is done, on a terminal only. */
function showProgress(place, plan) {
  return (share) => {
    if (process.stderr.isTTY)
      process.stderr.write(`\r${place} ${plan.scene} ${plan.size} ${Math.round(100 * share)} % `);
  };
}

function printHead() {
  console.log("where     scene            bodies   Box2D ms   thud ms   ratio    p99  worst");
}

/** Prints times in ms, and ratios of Box2D's time over thud's: median, 99th percentile, maximum. */
function printRow(where, r) {
  if (process.stderr.isTTY) process.stderr.write(`\r${" ".repeat(50)}\r`);
  const ratio = (key) => (r.box2d[key] / r.thud[key]).toFixed(2).padStart(7);
  console.log(
    `${where.padEnd(9)} ${r.scene.padEnd(14)} ${String(r.bodies).padStart(8)}   ` +
      `${r.box2d.median.toFixed(3).padStart(8)}  ${r.thud.median.toFixed(3).padStart(8)} ` +
      `${ratio("median")}${ratio("p99")}${ratio("max")}`,
  );
}

/** Measures the plans in this process. `done` is called with the place and each result. */
async function inNode(plans, done) {
  const thud = await import(`${web}package/dist/node.js`);
  const { default: Box2D } = await import(`${box2dFolder()}${DELUXE}`);
  const engine = await thud.load(new URL("../generated/thud-demo.wasm", import.meta.url));
  const b2 = await Box2D({ pthreadCount: 0 });
  for (const plan of plans) done("node", race(thud, engine, b2, plan, showProgress("node", plan)));
}

/**
 * Measures the plans in an empty page of Chromium, into which modules are imported from a server of
 * web/.
 */
async function inChromium(plans, done) {
  const { launchChromium } = await import("./browser.mjs");
  const { listenFrom } = await import("./serve.mjs");
  const { createStaticServer } = await import("./static-server.mjs");
  const server = createStaticServer(web);
  const url = `http://127.0.0.1:${await listenFrom(server, 0)}/`;
  const browser = await launchChromium({ webgl: false });
  try {
    const page = await browser.newPage();
    await page.goto(`${url}tools/bench-wasm.html`);
    const box2d = `/${relative(web, box2dFolder())}/${DELUXE}`;
    await page.evaluate(async (path) => {
      const thud = await import("/package/dist/index.js");
      const { default: Box2D } = await import(path);
      const { race } = await import("/tools/wasm-race.mjs");
      const engine = await thud.load("/generated/thud-demo.wasm");
      const b2 = await Box2D({ pthreadCount: 0 });
      window.measure = (plan) => race(thud, engine, b2, plan);
    }, box2d);
    for (const plan of plans) {
      showProgress("chromium", plan)(0);
      done("chromium", await page.evaluate((p) => window.measure(p), plan));
    }
  } finally {
    await browser.close();
    server.closeAllConnections();
    server.close();
  }
}

const options = readArguments(process.argv.slice(2));
const results = [];
printHead();
for (const place of options.places)
  await (place === "node" ? inNode : inChromium)(options.plans, (where, result) => {
    results.push({ where, ...result });
    printRow(where, result);
  });
if (options.json) writeFileSync(options.json, `${JSON.stringify(results, null, 1)}\n`);
process.exit(0);
