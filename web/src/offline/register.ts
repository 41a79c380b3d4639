/** Registers the service worker (sw.ts), which makes the page installable and usable offline. */
import { TAKE_OVER } from "./messages";

/**
 * Call it after the first picture, since the service worker fetches all files that later visits
 * need. Does nothing in browsers without service workers (no https, some private windows).
 *
 * `onUpdate` is called when a newer build is ready; its argument reloads the page with it.
 */
export async function keepOffline(onUpdate: (reload: () => void) => void): Promise<void> {
  // Files of the development server change while the page is open, and must not be cached.
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  let registration: ServiceWorkerRegistration;
  try {
    registration = await navigator.serviceWorker.register("./sw.js", { updateViaCache: "none" });
  } catch {
    // Switched off, or the host lacks the file: the page works, but not without a network.
    return;
  }
  const offer = (worker: ServiceWorker | null): void => {
    // If no service worker is in control, this one is the first, not that of a newer build.
    if (worker?.state === "installed" && navigator.serviceWorker.controller)
      onUpdate(() => replaceBy(worker));
  };
  const follow = (worker: ServiceWorker | null): void =>
    worker?.addEventListener("statechange", () => offer(worker));
  offer(registration.waiting);
  follow(registration.installing);
  registration.addEventListener("updatefound", () => follow(registration.installing));
  // Browsers look for a newer service worker by themselves, but some only long after opening.
  await registration.update().catch(() => {});
}

/** Lets a waiting service worker take control, and then reloads the page. */
function replaceBy(worker: ServiceWorker): void {
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), {
    once: true,
  });
  worker.postMessage(TAKE_OVER);
}
