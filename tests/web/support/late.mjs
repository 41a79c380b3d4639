/**
 * A slow network for the tests of the page: with the environment variable THUD_LATE=MS or
 * THUD_LATE=MS:SEED, every file of the page arrives 0 .. MS milliseconds late, in an order that
 * follows from the seed (1 by default) and the file's path. Scripts that the page loads after its
 * first picture (the list of scenes, panels, overlays, parts of the worker) then come in orders that
 * they seldom have on a fast machine. A test that fails only so acts before the page is ready for it,
 * or shows a fault of the page. For example, from web/:
 *
 *   THUD_LATE=1500:3 npm run test:page
 *
 * Not late are the page itself (HTML), rooms in which browsers meet, and the servers that tests start
 * themselves (built-page.mjs): these tests are on caching, policy and size.
 */
import { createHash } from "node:crypto";
import { extname } from "node:path";

const [ms = 0, seed = 1] = (process.env.THUD_LATE ?? "").split(":").map(Number);
if (!(ms >= 0 && Number.isInteger(seed))) throw new Error("THUD_LATE is not MS or MS:SEED");

/** Milliseconds by which the answer to a request is late, the same for each request of a file. */
function delayOf(url) {
  const path = url.replace(/[?#].*$/, "");
  if (["", ".html"].includes(extname(path))) return 0;
  const hash = createHash("sha256").update(`${seed} ${path}`).digest();
  return (hash.readUInt32LE() / 2 ** 32) * ms;
}

/** Makes the server of the page answer late, if THUD_LATE is set. */
export function answerLate(server) {
  if (ms === 0) return;
  const answers = server.listeners("request");
  server.removeAllListeners("request");
  server.on("request", (request, response) => {
    setTimeout(() => {
      for (const answer of answers) answer.call(server, request, response);
    }, delayOf(request.url ?? ""));
  });
}
