/**
 * Tests the page's content security policy: the page requests nothing from another host and
 * violates no directive, and code in a worker of the page cannot reach another host.
 */
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";
import { transformWithEsbuild } from "../../../web/node_modules/vite/dist/node/index.js";
import { writeServiceWorker } from "../../../web/tools/offline-plugin.mjs";
import { listenFrom } from "../../../web/tools/serve.mjs";
import { createStaticServer } from "../../../web/tools/static-server.mjs";
import { copyOfPage, createPlainServer, serve, untilOffline } from "../support/built-page.mjs";
import { drawLightly } from "../support/contexts.mjs";
import { browserOf, BROWSERS, PATIENCE, untilRunning } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/**
 * Opens a page that records its requests, and its errors, warnings and violations of the policy.
 */
async function openWatched(t, browser = "chromium") {
  const context = await (await browserOf(browser)).newContext();
  t.after(() => context.close());
  context.setDefaultTimeout(PATIENCE);
  await drawLightly(context);
  const page = await context.newPage();
  const requests = [];
  const troubles = [];
  context.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => troubles.push(error.message));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) troubles.push(message.text());
  });
  await page.exposeFunction("tellBreach", (text) => troubles.push(text));
  await page.addInitScript(() =>
    addEventListener("securitypolicyviolation", (event) =>
      window.tellBreach(`${event.effectiveDirective}: ${event.blockedURI}`),
    ),
  );
  return { page, requests, troubles };
}

for (const [browser, under] of [
  ["chromium", "/"],
  ["chromium", "/some/path/"],
  ["firefox", "/some/path/"],
])
  test(`page_at_${under}_asks_its_host_alone_and_breaks_no_policy_in_${browser}`, async (t) => {
    const { url } = await serve(t, createStaticServer(copyOfPage(t), under), under);
    const { page, requests, troubles } = await openWatched(t, browser);
    for (const search of ["", "?scene=platformer_game", "?level=towers"]) {
      await page.goto(url + search);
      await untilRunning(page);
    }
    await untilOffline(page);
    assert.deepEqual(requests.filter((address) => !address.startsWith(url)), []);
    assert.deepEqual(troubles, []);
  });

test("policy_of_the_page_stops_inline_scripts_styles_and_other_hosts", async (t) => {
  const { url } = await serve(t, createStaticServer(copyOfPage(t)));
  const { page, troubles } = await openWatched(t);
  await page.goto(url);
  await page.evaluate(async () => {
    document.body.append(Object.assign(document.createElement("script"), { text: "0" }));
    document.body.append(Object.assign(document.createElement("style"), { textContent: "a{}" }));
    await fetch("http://127.0.0.1:9/").catch(() => {});
  });
  for (const directive of ["script-src-elem", "style-src-elem", "connect-src"])
    await until(
      () => troubles,
      (told) => told.some((text) => text.startsWith(directive)),
      `no breach of ${directive}`,
    );
});

test("manifest_is_valid_and_its_icons_have_their_sizes", async (t) => {
  const { url } = await serve(t, createStaticServer(copyOfPage(t), "/a/"), "/a/");
  const { page } = await openWatched(t);
  await page.goto(url);
  const session = await page.context().newCDPSession(page);
  const { errors, url: manifestUrl } = await session.send("Page.getAppManifest");
  assert.deepEqual(errors, []);
  const manifest = await (await fetch(manifestUrl)).json();
  assert.ok(manifest.name && manifest.short_name);
  assert.equal(new URL(manifest.start_url, manifestUrl).href, url);
  assert.equal(new URL(manifest.scope, manifestUrl).href, url);
  for (const size of ["192x192", "512x512"])
    assert.ok(manifest.icons.some(({ sizes, type }) => sizes === size && type === "image/png"));
  assert.ok(manifest.icons.some(({ purpose }) => purpose === "maskable"));
  for (const { src, sizes, type } of manifest.icons) {
    const response = await fetch(new URL(src, manifestUrl));
    assert.equal(response.headers.get("content-type"), type, src);
    const bytes = Buffer.from(await response.arrayBuffer());
    if (type === "image/png")
      assert.equal(`${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`, sizes, src);
  }
});

/**
 * The code of a worker that tries each way to reach another host or to run code; it posts the name of
 * each before it tries, and at the end the names of those that worked. A worker that is held by nothing but its own listener may be collected while
 * it waits: then it would never answer. So `held` keeps the nested one. What is neither refused nor
 * done in time has not worked.
 */
const PROBE = `
let held;
const NESTED = "onmessage = ({ data }) => fetch(data + 'nested', { mode: 'no-cors' })" +
  ".then(() => postMessage(true), () => postMessage(false))";
const start = (code, host) => new Promise((done, fail) => {
  const worker = held = new Worker(URL.createObjectURL(code));
  worker.onmessage = ({ data }) => data ? done() : fail(new Error("confined"));
  worker.onerror = () => fail(new Error("refused"));
  worker.postMessage(host);
});
const tries = {
  fetch: (host) => fetch(host + "fetch", { mode: "no-cors" }),
  import: (host) => import(host + "import.js"),
  socket: (host) => new Promise((done, fail) => {
    const socket = new WebSocket(host.replace("http", "ws") + "socket");
    socket.onopen = done;
    socket.onerror = () => fail(new Error("refused"));
  }),
  compile: () => {
    const code = new Blob(["export default 1"], { type: "text/javascript" });
    return import(URL.createObjectURL(code));
  },
  own: () => import("./own.js"),
  nested: (host) => start(new Blob([NESTED], { type: "text/javascript" }), host),
  assemble: () => WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])),
  home: () => fetch("icon.svg"),
};
onmessage = async ({ data: host }) => {
  const reached = [];
  for (const [name, attempt] of Object.entries(tries)) {
    postMessage(name);
    const gaveUp = new Promise((done, fail) => setTimeout(fail, ${PATIENCE / 16}));
    const attempted = Promise.race([Promise.resolve(host).then(attempt), gaveUp]);
    await attempted.then(() => reached.push(name), () => {});
  }
  postMessage(reached);
};`;

/**
 * Runs PROBE in a worker of the page; returns the names of what worked and the requests that
 * another host received.
 */
async function probeFrom(t, create, browser, offline) {
  const folder = copyOfPage(t);
  writeFileSync(join(folder, "probe.js"), PROBE);
  writeFileSync(join(folder, "own.js"), "export default 1;");
  await writeServiceWorker(folder);
  const seen = [];
  const other = createServer((request, response) => {
    seen.push(request.url);
    response.writeHead(200, {
      "Access-Control-Allow-Origin": "*",
      "Cross-Origin-Resource-Policy": "cross-origin",
      "Content-Type": "text/javascript",
    });
    response.end();
  });
  other.on("upgrade", (request, socket) => {
    seen.push(request.url);
    socket.destroy();
  });
  const elsewhere = `http://127.0.0.1:${await listenFrom(other, 0)}/`;
  t.after(() => {
    other.closeAllConnections();
    other.close();
  });
  const { url } = await serve(t, create(folder));
  const visit = async () => {
    const { page } = await openWatched(t, browser);
    await page.goto(url);
    if (offline) await untilOffline(page);
    return page.evaluate(answerOfProbe, [elsewhere, PATIENCE]);
  };
  let answer = await visit();
  for (let again = 0; again < 2 && !answer.reached; again++) {
    console.error(`${browser}: the probe does not answer; it stands at "${answer.at}"; once more`);
    answer = await visit();
  }
  return { ...answer, seen };
}

/**
 * In the page: starts PROBE in a worker. Returns the names of what worked, or null and the try at
 * which it stands if it does not answer in time: Firefox has been seen to leave a worker of this test
 * without an answer, and what it may reach is then not known.
 */
function answerOfProbe([host, patience]) {
  return new Promise((done) => {
    let at = "start";
    const worker = new Worker("probe.js", { type: "module" });
    window.held = worker;
    worker.onmessage = ({ data }) => {
      if (typeof data === "string") at = data;
      else done({ reached: data });
    };
    worker.onerror = () => done({ reached: "the worker does not start" });
    worker.postMessage(host);
    setTimeout(() => done({ reached: null, at }), patience);
  });
}

// The tries of PROBE that must work.
const FREE = ["compile", "own", "assemble", "home"];

for (const browser of BROWSERS) {
  test(`code_in_a_worker_reaches_no_other_host_in_${browser}`, async (t) => {
    const { reached, seen } = await probeFrom(t, createStaticServer, browser, false);
    assert.deepEqual(reached, FREE);
    assert.deepEqual(seen, []);
  });

  test(`code_in_a_worker_of_a_plain_host_is_confined_by_the_service_worker_in_${browser}`, async (t) => {
    const { reached, seen } = await probeFrom(t, createPlainServer, browser, true);
    assert.deepEqual(reached, FREE);
    assert.deepEqual(seen, []);
  });
}

/** The result of isConfined for PROBE on a first visit to a host. */
async function confinedOn(t, create, prepare = async () => {}) {
  const folder = copyOfPage(t);
  const source = new URL("../../../web/src/offline/confine.ts", import.meta.url).pathname;
  const { code } = await transformWithEsbuild(readFileSync(source, "utf8"), source);
  writeFileSync(join(folder, "confine.js"), code);
  writeFileSync(join(folder, "probe.js"), PROBE);
  await writeServiceWorker(folder);
  const { url } = await serve(t, create(folder));
  const { page } = await openWatched(t);
  await prepare(page);
  await page.goto(url);
  return page.evaluate(async ([base, patience]) => {
    const { isConfined } = await import(`${base}confine.js`);
    return isConfined(`${base}probe.js`, patience);
  }, [url, PATIENCE]);
}

test("is_confined_is_true_at_once_where_the_host_sends_the_policy", async (t) => {
  assert.equal(await confinedOn(t, createStaticServer, withoutServiceWorker), true);
});

test("is_confined_waits_for_the_service_worker_on_a_plain_host", async (t) => {
  assert.equal(await confinedOn(t, createPlainServer), true);
});

test("is_confined_is_true_where_the_service_worker_comes_while_the_host_answers", async (t) => {
  const hold = (page) =>
    page.route(
      "**/probe.js",
      async (route) => {
        await untilOffline(page);
        await route.continue();
      },
      { times: 1 },
    );
  assert.equal(await confinedOn(t, createPlainServer, hold), true);
});

test("is_confined_is_false_on_a_plain_host_without_service_workers", async (t) => {
  assert.equal(await confinedOn(t, createPlainServer, withoutServiceWorker), false);
});

function withoutServiceWorker(page) {
  return page.addInitScript(() => delete Navigator.prototype.serviceWorker);
}

test("index_allows_workers_and_manifest_from_its_host_alone", () => {
  const index = readFileSync(new URL("../../../web/dist/index.html", import.meta.url), "utf8");
  const policy = /Content-Security-Policy"\s+content="([^"]+)"/.exec(index)[1];
  const directives = policy.split(";").map((text) => text.trim());
  for (const directive of [
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "worker-src 'self'",
    "manifest-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ])
    assert.ok(directives.includes(directive), directive);
});
