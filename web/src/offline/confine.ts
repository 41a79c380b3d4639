/** Tests whether the content security policy would keep a visitor's code from other hosts. */

/**
 * Whether a worker of this script gets a policy that lets it reach this page's host alone (see
 * tools/headers.mjs). Code from a link runs only then, or after the visitor was warned. If the host
 * does not send the policy, the service worker adds it. On a first visit no service worker is in
 * control yet: then this waits for it, at most `patience` milliseconds.
 */
export async function isConfined(script: string | URL, patience = 5000): Promise<boolean> {
  const workers = "serviceWorker" in navigator ? navigator.serviceWorker : null;
  // Read before fetching: if a service worker takes control during the fetch, the response is still
  // the host's, and must be fetched again.
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

/** Whether the response for the script has the policy; false if it cannot be fetched. */
async function hasPolicy(script: string | URL): Promise<boolean> {
  try {
    const response = await fetch(script);
    const policy = response.headers.get("Content-Security-Policy") ?? "";
    return /connect-src 'self'/.test(policy) && /script-src 'self'/.test(policy);
  } catch {
    return false;
  }
}
