/**
 * Tests the packed npm package in bundlers, by the recipes of its README. Each bundler bundles a
 * program; in Node, in a page and in a worker it must give the same bits as unbundled in Node,
 * under a content security policy that allows WebAssembly and no eval.
 */
import assert from "node:assert/strict";
import { copyFileSync, mkdirSync } from "node:fs";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { runInNewContext } from "node:vm";
import { BROWSERS } from "../../../web/tools/browser.mjs";
import { ISOLATION } from "../../../web/tools/headers.mjs";
import { ALONE, bring, expectedIn, host, makeProject, openBrowser, POLICY, recipeOf, tell, write } from "../support/packed.mjs";

const project = makeProject();
const { folder } = project;
const expected = tell(process.execPath, ["node.js"], folder);
after(project.remove);

const browsers = {};
before(async () => {
  for (const name of BROWSERS) browsers[name] = await openBrowser(name);
});
after(() => Promise.all(Object.values(browsers).map((browser) => browser.close())));

const inProject = (name) => join(folder, name);

const VITE = { root: folder, configFile: false, logLevel: "error" };
const [major, minor] = process.versions.node.split(".").map(Number);
const TOO_OLD = (major < 20 || (major === 20 && minor < 19)) && "Vite 8 needs Node.js 20.19";

/** Bundles the page for the web into the folder `out`, by the bundler's name. */
const WEB = {
  async Vite(out) {
    const { build } = await bring("vite");
    await build({ ...VITE, base: "./", build: { outDir: out, emptyOutDir: false } });
  },
  async webpack(out) {
    await bundleWithWebpack({ entry: { main: inProject("main.js") }, target: "web" }, out);
    copyFileSync(inProject("index.html"), join(out, "index.html"));
  },
  async Rollup(out) {
    const entries = ["main.js", "worker.js"].map(inProject);
    await bundleWithRollup(entries, { browser: true }, out);
    copyFileSync(inProject("index.html"), join(out, "index.html"));
  },
  async esbuild(out) {
    const entryPoints = ["main.js", "worker.js"].map(inProject);
    await bundleWithEsbuild({ entryPoints, platform: "browser", splitting: true }, out);
    copyFileSync(inProject("index.html"), join(out, "index.html"));
  },
};

/** Bundles node.js for Node into the folder `out`, by the bundler's name. */
const NODE = {
  async Vite(out) {
    const { build } = await bring("vite");
    await build({
      ...VITE,
      ssr: { noExternal: true },
      build: { ssr: inProject("node.js"), outDir: out },
    });
    copyAsTold("Rollup", out);
  },
  async webpack(out) {
    await bundleWithWebpack({ entry: { node: inProject("node.js") }, target: "node" }, out);
    // The output is CommonJS; the project's package.json would make Node take it for a module.
    write(out, { "package.json": "{}" });
  },
  Rollup: (out) => bundleWithRollup([inProject("node.js")], { exportConditions: ["node"] }, out),
  esbuild: (out) => bundleWithEsbuild({ entryPoints: [inProject("node.js")], platform: "node" }, out),
};

/** The README's option for the dev server of Vite before version 8. */
function viteRecipe() {
  const [options] = recipeOf("Vite");
  return runInNewContext(`({ ${options} })`);
}

async function bundleWithWebpack(options, out) {
  const { default: webpack } = await bring("webpack");
  const compiler = webpack({
    ...options,
    context: folder,
    mode: "production",
    // Minifying takes most of webpack's time, and other bundlers here do it.
    optimization: { minimize: false },
    output: { path: out },
  });
  const stats = await new Promise((done, fail) =>
    compiler.run((error, result) => (error ? fail(error) : done(result))),
  );
  await new Promise((done) => compiler.close(done));
  assert.deepEqual(stats.toJson({ all: false, errors: true, warnings: true }).errors, []);
}

async function bundleWithRollup(input, resolve, out) {
  const { rollup } = await bring("rollup");
  const { nodeResolve } = await bring("@rollup/plugin-node-resolve");
  const warned = [];
  const bundle = await rollup({
    input,
    plugins: [nodeResolve(resolve)],
    external: /^node:/,
    onwarn: ({ message }) => warned.push(message),
  });
  assert.deepEqual(warned.filter((text) => !text.includes("parse-xml")), []);
  await bundle.write({ dir: out, format: "es" });
  await bundle.close();
  copyAsTold("Rollup", out);
}

async function bundleWithEsbuild(options, out) {
  const { build } = await bring("esbuild");
  await build({ ...options, absWorkingDir: folder, bundle: true, format: "esm", outdir: out, logLevel: "error" });
  copyAsTold("esbuild", out);
}

/** Copies the engine's files as the README says, except to another folder. */
function copyAsTold(name, out) {
  for (const recipe of recipeOf(name)) {
    const [, ...files] = recipe.split(" ");
    assert.equal(files.pop(), "dist/");
    for (const file of files) copyFileSync(inProject(file), join(out, basename(file)));
  }
}

function outOf(name) {
  const out = inProject(`out-${name}`);
  mkdirSync(out);
  return out;
}

for (const [name, bundle] of Object.entries(NODE))
  test(`program_bundled_by_${name}_says_the_same_bits_in_node`, { skip: name === "Vite" && TOO_OLD }, async () => {
    const out = outOf(`node-${name}`);
    await bundle(out);
    assert.deepEqual(tell(process.execPath, ["node.js"], out), expected);
  });

for (const [name, bundle] of Object.entries(WEB))
  test(`page_bundled_by_${name}_says_the_same_bits_under_a_policy_without_eval`, { skip: name === "Vite" && TOO_OLD }, async (t) => {
    const out = outOf(name);
    await bundle(out);
    const { url, close } = await host(out);
    t.after(close);
    for (const browser of BROWSERS) {
      const { told, troubles } = await browsers[browser].tell(url);
      assert.deepEqual(told, expectedIn(browser, expected), browser);
      assert.deepEqual(troubles, [], browser);
    }
  });

test("page_that_is_not_isolated_gets_the_engine_without_threads", async (t) => {
  const out = outOf("not-isolated");
  await WEB.esbuild(out);
  const { url, close } = await host(out, POLICY, {});
  t.after(close);
  for (const browser of BROWSERS) {
    const { told, troubles } = await browsers[browser].tell(url);
    const alone = { ...expected, shared: ALONE };
    assert.deepEqual(told, [alone, alone], browser);
    assert.deepEqual(troubles, [], browser);
  }
});

/** The page's own Vite is older than version 8. */
const SERVERS = {
  "Vite_8": [() => bring("vite"), {}],
  "Vite_before_8": [() => import("../../../web/node_modules/vite/dist/node/index.js"), viteRecipe()],
};

for (const [name, [bringVite, options]] of Object.entries(SERVERS)) {
  const skip = name === "Vite_8" && TOO_OLD;
  test(`page_from_the_dev_server_of_${name}_says_the_same_bits`, { skip }, async (t) => {
    const { createServer } = await bringVite();
    const server = await createServer({
      ...VITE,
      ...options,
      cacheDir: inProject(`cache-${name}`),
      server: { port: 0, host: "127.0.0.1", headers: ISOLATION },
    });
    t.after(() => server.close());
    await server.listen();
    const [url] = server.resolvedUrls.local;
    const { told, troubles } = await browsers.chromium.tell(url);
    assert.deepEqual(told, [expected, expected]);
    assert.deepEqual(troubles, []);
  });
}

test("script_that_does_not_know_where_it_lies_is_told_what_load_needs", async () => {
  const out = outOf("script");
  const { build } = await bring("esbuild");
  const entryPoints = [inProject("node.js")];
  const options = { entryPoints, outdir: out, bundle: true, platform: "node", logLevel: "silent" };
  await build({ ...options, format: "cjs" });
  write(out, { "package.json": "{}" });
  assert.throws(() => tell(process.execPath, ["node.js"], out), /give load the URL of thud.wasm/);
});
