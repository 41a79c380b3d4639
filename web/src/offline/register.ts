/** Makes the page installable and usable offline, where the browser has service workers. */
import { TAKE_OVER } from "./messages";

/**
 * Call it once the first picture is there, since it fetches what a later visit needs. Does nothing
 * where there are no service workers (an address without https, some private windows).
 *
 * `onUpdate` is called when a newer build is ready; its argument reloads the page with it.
 */
export async function keepOffline(onUpdate: (reload: () => void) => void): Promise<void> {
  // The development server's files change under the page.
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  let registration: ServiceWorkerRegistration;
  try {
    registration = await navigator.serviceWorker.register("./sw.js", { updateViaCache: "none" });
  } catch {
    // Switched off, or the host lacks the file: the page works, only not without a network.
    return;
  }
  const offer = (worker: ServiceWorker | null): void => {
    // Where no worker is in control, the new one is the first, and no newer build.
    if (worker?.state === "installed" && navigator.serviceWorker.controller)
      onUpdate(() => replaceBy(worker));
  };
  const follow = (worker: ServiceWorker | null): void =>
    worker?.addEventListener("statechange", () => offer(worker));
  offer(registration.waiting);
  follow(registration.installing);
  registration.addEventListener("updatefound", () => follow(registration.installing));
  // Browsers look for a newer build by themselves, but some only long after the page was opened.
  await registration.update().catch(() => {});
}

function replaceBy(worker: ServiceWorker): void {
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), {
    once: true,
  });
  worker.postMessage(TAKE_OVER);
}
