/** Copies of the built page and servers for them, for the tests of caching, policy and size. */
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { listenFrom } from "../../../web/tools/serve.mjs";
import { createStaticServer } from "../../../web/tools/static-server.mjs";

/** A copy of web/dist that the test may change; it is removed when the test `t` ends. */
export function copyOfPage(t) {
  const folder = mkdtempSync(join(tmpdir(), "thud-page-"));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  cpSync(fileURLToPath(new URL("../../../web/dist", import.meta.url)), folder, { recursive: true });
  return folder;
}

/** Serves a folder until the test ends or `cut` is called. */
export async function serve(t, server, under = "/") {
  // Without compression: each server would compress every file again for the service worker.
  server.prependListener("request", ({ headers }) => delete headers["accept-encoding"]);
  const port = await listenFrom(server, 0);
  const cut = () => {
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  t.after(cut);
  return { url: `http://127.0.0.1:${port}${under}`, cut };
}

/**
 * A server that sends only the headers Content-Type and Content-Encoding, as most static hosts do.
 */
export function createPlainServer(folder) {
  const full = createStaticServer(folder);
  return createServer((request, response) => {
    const writeHead = response.writeHead.bind(response);
    response.writeHead = (status, headers) => {
      const { "Content-Type": type, "Content-Encoding": encoding } = headers;
      const few = { "Content-Type": type, ...(encoding && { "Content-Encoding": encoding }) };
      return writeHead(status, few);
    };
    full.emit("request", request, response);
  });
}

/**
 * Waits until the page's service worker has cached all files of the build and controls the page.
 */
export function untilOffline(page) {
  return page.waitForFunction(() => navigator.serviceWorker.controller?.state === "activated");
}
