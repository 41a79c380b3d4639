/**
 * Takes from the worker what reaches beyond this page, before a visitor's code runs in it: such
 * code may have come with a link from a stranger. The policy that the host or the service worker
 * sends with the worker (tools/headers.mjs) is the outer fence and also stops `import`; this one
 * holds where no policy is sent, against all but an attack on the language's own objects, and
 * keeps storage and channels to other pages of this host out of reach as well.
 */

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
  // A font may be loaded from anywhere.
  "FontFace",
  "fonts",
] as const;

const TAKEN_FROM_NAVIGATOR = ["storage", "storageBuckets", "serviceWorker", "locks"] as const;

let raised = false;

/** `base` is the page's address; files under its folder can still be fetched. */
export function raiseFence(base: string): void {
  if (raised) return;
  raised = true;
  for (const name of TAKEN) takeAway(globalThis, name);
  for (const name of TAKEN_FROM_NAVIGATOR) takeAway(navigator, name);
  const limited = limitFetch(globalThis.fetch.bind(globalThis), Request, new URL(".", base).href);
  // The one on the prototype would be found again where the global's own is deleted.
  takeAway(globalThis, "fetch");
  Object.defineProperty(globalThis, "fetch", { value: limited });
}

/** Some are the object's own, others its prototypes'. */
function takeAway(from: object, name: string): void {
  for (let owner: object | null = from; owner; owner = Object.getPrototypeOf(owner))
    Reflect.deleteProperty(owner, name);
}

function limitFetch(
  fetch: typeof globalThis.fetch,
  PlainRequest: typeof Request,
  folder: string,
): typeof globalThis.fetch {
  return async (input, init) => {
    // Nothing is sent on to where an answer points.
    const request = new PlainRequest(input, { ...init, redirect: "error" });
    if (!request.url.startsWith(folder))
      throw new TypeError(`${request.url} is not a file of this page: a scene can read no other.`);
    return fetch(request);
  };
}
