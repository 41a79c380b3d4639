/**
 * The service worker: keeps the page's files, so that it opens without a network, and lets no
 * request of the page or its workers leave for another host. tools/offline-plugin.mjs puts the
 * build's files into `BUILD` and writes the result to dist/sw.js.
 */
import { hasSimd } from "../wasm/simd";
import { TAKE_OVER } from "./messages";

interface BuildFile {
  /** Relative to this worker. */
  url: string;
  /** As in the integrity attribute: a file of another build is refused. */
  integrity: string;
}

declare const BUILD: {
  version: string;
  /** Of thud and Box2D only the flavour is kept that this browser runs. */
  files: BuildFile[];
  simd: BuildFile[];
  scalar: BuildFile[];
  headers: Record<string, string>;
  scriptPolicy: string;
};
declare const self: ServiceWorkerGlobalScope;

/** Caches belong to a whole host, which may have other pages, and this page at other paths. */
const PREFIX = `thud ${self.registration.scope} `;
const CACHE = PREFIX + BUILD.version;
const INDEX = addressOf("index.html");

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));
self.addEventListener("message", ({ data }) => {
  if (data === TAKE_OVER) void self.skipWaiting();
});
self.addEventListener("fetch", (event) => {
  const { origin } = new URL(event.request.url);
  // The page's policy forbids such requests by itself, but a worker's policy is up to the host.
  if (origin !== self.location.origin) event.respondWith(Response.error());
  else if (event.request.method === "GET") event.respondWith(answer(event.request));
});

/** All or nothing: while any file is missing, what was there before stays. */
async function install(): Promise<void> {
  const cache = await caches.open(CACHE);
  const files = [...BUILD.files, ...(hasSimd() ? BUILD.simd : BUILD.scalar)];
  await Promise.all(files.map((file) => keep(cache, file)));
}

/** Of former builds nothing stays. */
async function activate(): Promise<void> {
  for (const name of await caches.keys())
    if (name.startsWith(PREFIX) && name !== CACHE) await caches.delete(name);
  await self.clients.claim();
}

async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const address = request.url.replace(/[?#].*$/, "");
  const isPage = request.mode === "navigate" && address === addressOf("./");
  return withHeaders((await cache.match(isPage ? INDEX : address)) ?? (await fetch(request)));
}

/** Fetches a file and keeps it; an error or a file of another build is never kept. */
async function keep(cache: Cache, { url, integrity }: BuildFile): Promise<void> {
  const address = addressOf(url);
  // Asks the host even where the browser's own cache would answer, maybe with an older file.
  const response = await fetch(address, { integrity, cache: "no-cache" });
  if (!response.ok) throw new TypeError(`${address}: ${response.status} ${response.statusText}`);
  await cache.put(address, response);
}

/** What serve.mjs sends and a simple host does not; see tools/headers.mjs. */
function withHeaders(response: Response): Response {
  if (response.type === "error" || response.type.startsWith("opaque")) return response;
  const headers = new Headers(response.headers);
  for (const [name, value] of Object.entries(BUILD.headers)) headers.set(name, value);
  if (/javascript/.test(headers.get("Content-Type") ?? ""))
    headers.set("Content-Security-Policy", BUILD.scriptPolicy);
  const { status, statusText } = response;
  const body = status === 204 || status === 304 ? null : response.body;
  return new Response(body, { status, statusText, headers });
}

function addressOf(url: string): string {
  return new URL(url, self.registration.scope).href;
}
