/**
 * Bounds the memory of a visitor's code: a scene that keeps ever more JavaScript objects would take
 * the whole tab with it. The engine's own memory is bounded in the worker (worker/watch.ts), which
 * cannot see what its heap of objects holds; the page can, where it is isolated from other origins
 * (tools/headers.mjs) and the browser measures it, as Chromium does. Loaded with the first such code.
 */
import type { App } from "./app";

/** Of the page and its workers together, in bytes. */
const MOST_BYTES = 2 ** 30;
/** Milliseconds between two measurements, of which each takes Chromium some 15 s. */
const PAUSE = 1000;

type Measuring = Performance & {
  measureUserAgentSpecificMemory?(): Promise<{ bytes: number }>;
};

let watching = false;

/** Until none of a visitor's code runs. */
export async function watchMemory(app: App): Promise<void> {
  if (watching) return;
  watching = true;
  try {
    while (app.state.code !== null && app.scene) {
      const { run } = app.scene;
      const measured = await (performance as Measuring).measureUserAgentSpecificMemory?.();
      if (!measured) return;
      // What was measured may be of the scene before.
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
