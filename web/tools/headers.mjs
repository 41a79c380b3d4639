/** The headers that the page is served with, by serve.mjs and offline by the service worker. */

/**
 * Cross-origin isolation: the clocks of an isolated page tick in 5 microseconds, of others in 100,
 * and a step of a small scene takes less than that. It costs nothing here, since the page loads
 * nothing from elsewhere.
 */
export const ISOLATION = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
  "Cross-Origin-Resource-Policy": "same-origin",
};

/**
 * The policy of workers. The page has its own, stricter one in index.html, which a worker that is
 * loaded from an address does not inherit. A visitor's code, which may have come with a link from
 * a stranger, runs in the physics worker and nowhere else. It may compute what it likes
 * ('unsafe-eval' and blob: are how it is compiled, and Box2D's loader makes functions of text), but
 * it must not reach another host: fetch, import, WebSocket and importScripts end at this one.
 * Firefox takes what a worker imports for workers: 'none' there would stop every import. A worker
 * that a worker starts is this host's own, and is sent the same policy.
 * It is sent with every script, because only workers heed it there.
 */
export const WORKER_POLICY =
  "default-src 'none'; script-src 'self' blob: 'unsafe-eval'; connect-src 'self'; " +
  "worker-src 'self'";
