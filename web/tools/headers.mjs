/** The HTTP headers of the page, which serve.mjs sends, and offline the service worker. */

/**
 * Cross-origin isolation: performance.now() has a resolution of 5 microseconds in an isolated page,
 * of 100 in others, which is longer than a step of a small scene. It has no drawback here, since
 * the page loads nothing from other origins.
 */
export const ISOLATION = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
  "Cross-Origin-Resource-Policy": "same-origin",
};

/**
 * The content security policy of workers. The page has its own, stricter policy in index.html,
 * which a worker that is loaded from a URL does not inherit. Code of a visitor, which may come with
 * a link from a stranger, runs in the physics worker only. It may compute anything ('unsafe-eval'
 * and blob: are needed to compile it, and Box2D's loader creates functions from text), but it must
 * not reach another host: fetch, import, WebSocket and importScripts are limited to this one.
 * Firefox applies worker-src to the imports of a worker, so 'none' there would block every import;
 * a worker that a worker starts comes from this host, with the same policy. The policy is sent with
 * every script, since browsers apply it to a script only where that starts a worker.
 */
export const WORKER_POLICY =
  "default-src 'none'; script-src 'self' blob: 'unsafe-eval'; connect-src 'self'; " +
  "worker-src 'self'";
