/**
 * Limits the memory of a visitor's code: a scene that creates ever more JavaScript objects would
 * crash the whole tab. The worker limits the engine's own memory (worker/watch.ts), but cannot
 * measure its JavaScript heap; the page can where it is cross-origin isolated (tools/headers.mjs)
 * and the browser measures it, as Chromium does. Imported when a visitor's code first runs.
 */
import type { App } from "./app";

/** Limit for the page and its workers together, in bytes. Chosen, as in worker/watch.ts. */
const MOST_BYTES = 2 ** 30;
/** Milliseconds from one measurement to the next; each takes about 15 s in Chromium. Chosen. */
const PAUSE = 1000;

type Measuring = Performance & {
  measureUserAgentSpecificMemory?(): Promise<{ bytes: number }>;
};

let watching = false;

/** Measures again and again until no visitor's code runs; stops a scene that exceeds the limit. */
export async function watchMemory(app: App): Promise<void> {
  if (watching) return;
  watching = true;
  try {
    while (app.state.code !== null && app.scene) {
      const { run } = app.scene;
      const measured = await (performance as Measuring).measureUserAgentSpecificMemory?.();
      if (!measured) return;
      // If another scene has started since, the measurement may be of the one before.
      if (measured.bytes > MOST_BYTES && app.state.code !== null && app.scene?.run === run)
        app.end({ message: "It holds more than 1 GB, so it was ended.", tooLarge: true });
      await new Promise((done) => setTimeout(done, PAUSE));
    }
  } catch {
    // Not isolated, or not allowed here: nothing can be measured.
  } finally {
    watching = false;
  }
}
