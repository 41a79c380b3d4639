/**
 * The service worker. It caches the page's files, so that the page opens without a network, and
 * refuses requests of the page and its workers to other hosts. tools/offline-plugin.mjs puts the
 * list of the build's files into `BUILD` and writes the result to dist/sw.js.
 */
import { hasSimd } from "../wasm/simd";
import { TAKE_OVER } from "./messages";

interface BuildFile {
  /** The address, relative to this worker. */
  url: string;
  /** A hash as in the integrity attribute, by which a file of another build is refused. */
  integrity: string;
}

declare const BUILD: {
  version: string;
  /** Files for every browser; with them are cached either those with SIMD or the scalar ones. */
  files: BuildFile[];
  simd: BuildFile[];
  scalar: BuildFile[];
  headers: Record<string, string>;
  scriptPolicy: string;
};
declare const self: ServiceWorkerGlobalScope;

/** The beginning of cache names. A host's caches are shared by its pages, of which some may be this
 * page at another path, so the names contain the path. */
const PREFIX = `thud ${self.registration.scope} `;
const CACHE = PREFIX + BUILD.version;
const INDEX = addressOf("index.html");
/** The documentation site, of which what was visited is kept, until the next build. */
const SITE = addressOf("docs/");
const SITE_CACHE = `${CACHE} docs`;

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));
self.addEventListener("message", ({ data }) => {
  if (data === TAKE_OVER) void self.skipWaiting();
});
self.addEventListener("fetch", (event) => {
  const { origin } = new URL(event.request.url);
  // The page's own policy forbids requests to other hosts, but that of its workers is a header,
  // which the host may not send.
  if (origin !== self.location.origin) event.respondWith(Response.error());
  else if (event.request.method === "GET") event.respondWith(answer(event.request));
});

/** Caches all files. If one cannot be fetched the installation fails, and the former service worker
 * and its cache stay. */
async function install(): Promise<void> {
  const cache = await caches.open(CACHE);
  const files = [...BUILD.files, ...(hasSimd() ? BUILD.simd : BUILD.scalar)];
  await Promise.all(files.map((file) => keep(cache, file)));
}

/** Deletes the caches of former builds, and takes control of the open pages. */
async function activate(): Promise<void> {
  for (const name of await caches.keys())
    if (name.startsWith(PREFIX) && !name.startsWith(CACHE)) await caches.delete(name);
  await self.clients.claim();
}

/** The response to a GET request: from the cache, or else from the host. */
async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE);
  const address = request.url.replace(/[?#].*$/, "");
  if (address.startsWith(SITE)) return withHeaders(await answerFromSite(request, address));
  const isPage = request.mode === "navigate" && address === addressOf("./");
  return withHeaders((await cache.match(isPage ? INDEX : address)) ?? (await fetch(request)));
}

/** A file of the site: from the host, or without a network as it was when last visited. */
async function answerFromSite(request: Request, address: string): Promise<Response> {
  const cache = await caches.open(SITE_CACHE);
  try {
    const response = await fetch(request);
    if (response.ok) await cache.put(address, response.clone());
    return response;
  } catch (error) {
    const kept = await cache.match(address);
    if (!kept) throw error;
    return kept;
  }
}

/** Fetches a file and caches it; throws on an error or if it is a file of another build. */
async function keep(cache: Cache, { url, integrity }: BuildFile): Promise<void> {
  const address = addressOf(url);
  // Asks the host even if the browser's own cache has the file, which may be an older one.
  const response = await fetch(address, { integrity, cache: "no-cache" });
  if (!response.ok) throw new TypeError(`${address}: ${response.status} ${response.statusText}`);
  await cache.put(address, response);
}

/** The response with the headers that serve.mjs sends and a simple host does not; see
 * tools/headers.mjs. */
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

/** The full address of a file named relative to the page. */
function addressOf(url: string): string {
  return new URL(url, self.registration.scope).href;
}
