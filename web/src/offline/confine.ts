/** Whether a visitor's code would be kept from other hosts. */

/**
 * Whether a worker of that script is held to a policy that lets it reach this host alone (see
 * tools/headers.mjs): code that came with a link is to run only then, or after a question. A host
 * that sends no such policy leaves it to the service worker, which is not there yet on a first
 * visit: then this waits for it, `patience` milliseconds at most.
 */
export async function isConfined(script: string | URL, patience = 5000): Promise<boolean> {
  const workers = "serviceWorker" in navigator ? navigator.serviceWorker : null;
  // Looked at first: one that takes control while the host answers has not answered itself.
  const controlled = Boolean(workers?.controller);
  if (await hasPolicy(script)) return true;
  if (!workers || controlled) return false;
  if (!workers.controller)
    await new Promise<void>((done) => {
      workers.addEventListener("controllerchange", () => done(), { once: true });
      setTimeout(done, patience);
    });
  return workers.controller !== null && hasPolicy(script);
}

async function hasPolicy(script: string | URL): Promise<boolean> {
  try {
    const response = await fetch(script);
    const policy = response.headers.get("Content-Security-Policy") ?? "";
    return /connect-src 'self'/.test(policy) && /script-src 'self'/.test(policy);
  } catch {
    return false;
  }
}
