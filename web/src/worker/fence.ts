/**
 * Removes from the worker's global object whatever could reach beyond this page, before a visitor's
 * code runs in it: such code may have come with a link from a stranger.
 *
 * The first line of defence is the content security policy that the host or the service worker
 * sends with the worker (tools/headers.mjs); it also restricts `import`. The removal here works
 * where no policy is sent, against all code that does not tamper with the built-in objects of the
 * language. It also removes storage and channels to other pages of the same host.
 */

/** Globals that are removed. */
const TAKEN = [
  "XMLHttpRequest",
  "WebSocket",
  "WebSocketStream",
  "WebTransport",
  "EventSource",
  "RTCPeerConnection",
  "BroadcastChannel",
  "Worker",
  "SharedWorker",
  "importScripts",
  "indexedDB",
  "caches",
  "cookieStore",
  "webkitRequestFileSystem",
  "webkitRequestFileSystemSync",
  "webkitResolveLocalFileSystemURL",
  "webkitResolveLocalFileSystemSyncURL",
  // A font can be loaded from any address.
  "FontFace",
  "fonts",
] as const;

const TAKEN_FROM_NAVIGATOR = ["storage", "storageBuckets", "serviceWorker", "locks"] as const;

let raised = false;

/**
 * Removes the globals, once. Files in the folder of `base`, the page's address, can still be
 * fetched.
 */
export function raiseFence(base: string): void {
  if (raised) return;
  raised = true;
  for (const name of TAKEN) takeAway(globalThis, name);
  for (const name of TAKEN_FROM_NAVIGATOR) takeAway(navigator, name);
  const limited = limitFetch(globalThis.fetch.bind(globalThis), Request, new URL(".", base).href);
  // Deleting only the global's own property would uncover the one of its prototype.
  takeAway(globalThis, "fetch");
  Object.defineProperty(globalThis, "fetch", { value: limited });
}

/** Deletes a property from an object and from all of its prototypes. */
function takeAway(from: object, name: string): void {
  for (let owner: object | null = from; owner; owner = Object.getPrototypeOf(owner))
    Reflect.deleteProperty(owner, name);
}

/** A `fetch` that rejects addresses outside of `folder`. */
function limitFetch(
  fetch: typeof globalThis.fetch,
  PlainRequest: typeof Request,
  folder: string,
): typeof globalThis.fetch {
  return async (input, init) => {
    // A redirect is an error, because it could lead out of the folder.
    const request = new PlainRequest(input, { ...init, redirect: "error" });
    if (!request.url.startsWith(folder))
      throw new TypeError(`${request.url} is not a file of this page: a scene can read no other.`);
    return fetch(request);
  };
}
