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
import { createRooms } from "../../../web/tools/rooms.mjs";
import { createStaticServer } from "../../../web/tools/static-server.mjs";

const script = fileURLToPath(new URL("../../../web/tools/serve.mjs", import.meta.url));
const folder = fileURLToPath(new URL("../../../web/dist", import.meta.url));

/** Requests a path as it is; fetch would normalize it. */
function get(port, path, method = "GET", headers = {}, text = "") {
  return new Promise((done, fail) => {
    request({ port, path, method, headers, host: "127.0.0.1" }, (response) => {
      const chunks = [];
      response.on("data", (chunk) => chunks.push(chunk));
      response.on("end", () => done(Object.assign(response, { body: Buffer.concat(chunks) })));
    })
      .on("error", fail)
      .end(text);
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

test("server_keeps_what_browsers_leave_in_rooms_until_it_is_taken", async (t) => {
  const server = createStaticServer(folder);
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  const port = await listenFrom(server, 0);
  const ask = async (path, method, text) => {
    const { statusCode, body } = await get(port, `/rooms/${path}`, method, {}, text);
    return [statusCode, body.toString()];
  };
  assert.deepEqual(JSON.parse((await get(port, "/rooms.json")).body), { rooms: true });
  assert.deepEqual(await ask("a/answer", "PUT", "early"), [503, ""], "a room that nobody has opened");
  assert.deepEqual(await ask("a/offer", "PUT", "come"), [204, ""]);
  assert.deepEqual(await ask("b/offer"), [204, ""], "another room");
  assert.deepEqual(await ask("a/offer"), [200, "come"]);
  assert.deepEqual(await ask("a/offer"), [204, ""], "it was taken");
  assert.deepEqual(await ask("a/answer", "PUT", "I do"), [204, ""]);
  assert.deepEqual(await ask("a/answer"), [200, "I do"]);
  assert.deepEqual(await ask("a/offer", "PUT", "x".repeat(5000)), [413, ""]);
  assert.equal((await ask("a/offer", "POST", "x"))[0], 405);
  for (const path of ["A/offer", "a/b", `${"a".repeat(41)}/offer`, "../rooms/a/offer"])
    assert.notEqual((await ask(path))[0], 200, path);
  await ask("a/offer", "PUT", "come");
  await ask("a/offer", "DELETE");
  assert.deepEqual(await ask("a/offer"), [204, ""], "it was closed");
});

/** Asks for something of room "a", without a server. */
function askRoom(rooms, what, method, texts = []) {
  let told;
  return new Promise((end) => {
    const response = { writeHead: (status) => (told = status), end: (text) => end([told, text]) };
    const request = { method, [Symbol.asyncIterator]: () => texts.values() };
    assert.ok(rooms(`rooms/a/${what}`, request, response));
  });
}

test("invitation_that_nobody_answers_is_given_to_the_next", async () => {
  let now = 0;
  const rooms = createRooms(() => now);
  const ask = (...of) => askRoom(rooms, ...of);
  await ask("offer", "PUT", ["come"]);
  assert.deepEqual(await ask("offer", "GET"), [200, "come"]);
  now += 5000;
  assert.deepEqual(await ask("answer", "GET"), [204, ""]);
  assert.deepEqual(await ask("offer", "GET"), [204, ""], "it may still be answered");
  now += 4000;
  assert.deepEqual(await ask("offer", "GET"), [200, "come"], "to somebody else");
  await ask("answer", "PUT", ["I do"]);
  now += 1000;
  assert.deepEqual(await ask("answer", "GET"), [200, "I do"]);
  now += 9000;
  await ask("answer", "GET");
  assert.deepEqual(await ask("offer", "GET"), [204, ""], "it was answered");
});

test("room_whose_host_asks_no_more_is_closed", async () => {
  let now = 0;
  const rooms = createRooms(() => now);
  const ask = (...of) => askRoom(rooms, ...of);
  await ask("offer", "PUT", ["come"]);
  for (let i = 0; i < 5; i++) {
    now += 5000;
    assert.deepEqual(await ask("answer", "GET"), [204, ""]);
  }
  now += 7000;
  assert.deepEqual(await ask("offer", "GET"), [204, ""]);
});
