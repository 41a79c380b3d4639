/**
 * Tests the static server: content types, compression, no file from outside its folder, and the
 * next port when one is in use.
 */
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { listenFrom } from "../../../web/tools/serve.mjs";
import { createStaticServer } from "../../../web/tools/static-server.mjs";

const script = fileURLToPath(new URL("../../../web/tools/serve.mjs", import.meta.url));
const folder = fileURLToPath(new URL("../../../web/dist", import.meta.url));

/** Requests a path as it is; fetch would normalize it. */
function get(port, path, method = "GET", headers = {}) {
  return new Promise((done, fail) => {
    request({ port, path, method, headers, host: "127.0.0.1" }, (response) => {
      const chunks = [];
      response.on("data", (chunk) => chunks.push(chunk));
      response.on("end", () => done(Object.assign(response, { body: Buffer.concat(chunks) })));
    })
      .on("error", fail)
      .end();
  });
}

test("server_sends_files_with_their_types_and_refuses_the_rest", async (t) => {
  const server = createStaticServer(folder);
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  const port = await listenFrom(server, 0);
  const index = await get(port, "/?scene=gas");
  assert.equal(index.statusCode, 200);
  assert.match(index.headers["content-type"], /^text\/html/);
  const outside = ["/../package.json", "/%2e%2e/package.json", "/..%2fpackage.json"];
  for (const path of [...outside, "/no-such", "/%", "/%00"])
    assert.equal((await get(port, path)).statusCode, 404, path);
  assert.equal((await get(port, "/", "POST")).statusCode, 405);
});

test("server_compresses_when_asked_and_sends_nothing_that_is_known", async (t) => {
  const server = createStaticServer(folder);
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  const port = await listenFrom(server, 0);
  const plain = await get(port, "/");
  assert.equal(plain.headers["content-encoding"], undefined);
  for (const [encoding, decode] of [["br", brotliDecompressSync], ["gzip", gunzipSync]]) {
    const packed = await get(port, "/", "GET", { "Accept-Encoding": encoding });
    assert.equal(packed.headers["content-encoding"], encoding);
    assert.ok(packed.body.length < plain.body.length / 2);
    assert.deepEqual(decode(packed.body), plain.body);
  }
  const again = await get(port, "/", "GET", { "If-None-Match": plain.headers.etag });
  assert.deepEqual([again.statusCode, again.body.length], [304, 0]);
  const head = await get(port, "/", "HEAD");
  assert.equal(Number(head.headers["content-length"]), plain.body.length);
});

test("changed_file_is_sent_anew", async (t) => {
  const copy = mkdtempSync(join(tmpdir(), "thud-server-"));
  t.after(() => rmSync(copy, { recursive: true }));
  writeFileSync(join(copy, "a.js"), "1");
  const server = createStaticServer(copy);
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  const port = await listenFrom(server, 0);
  const first = await get(port, "/a.js");
  writeFileSync(join(copy, "a.js"), "22");
  const second = await get(port, "/a.js", "GET", { "If-None-Match": first.headers.etag });
  assert.deepEqual([second.statusCode, second.body.toString()], [200, "22"]);
});

test("taken_port_is_said_and_the_next_one_tried", async (t) => {
  const holder = createStaticServer(folder);
  t.after(() => holder.close());
  const taken = await listenFrom(holder, 18080);
  const child = spawn(process.execPath, [script, "--port", String(taken)]);
  t.after(() => child.kill("SIGKILL"));
  let output = "";
  await new Promise((done, fail) => {
    child.stdout.on("data", (data) => {
      output += data;
      if (output.includes("http://")) done();
    });
    child.on("exit", () => fail(new Error(output)));
  });
  assert.match(output, new RegExp(`Port ${taken} is taken; trying ${taken + 1}`));
  child.removeAllListeners("exit");
  const code = new Promise((done) => child.on("exit", done));
  child.kill("SIGINT");
  assert.equal(await code, 0);
});

test("bad_port_is_refused_with_usage", () => {
  const words = [script, "--port", "zero"];
  const { status, stderr } = spawnSync(process.execPath, words, { encoding: "utf8" });
  assert.equal(status, 2);
  assert.match(stderr, /1 to 65535[\s\S]*usage:/);
});
