/**
 * Browser contexts that several tests use one after another. A second page in the same context and
 * process compiles neither the page's scripts nor the engine again, which is most of the cost of
 * opening it. Other data of the earlier page is cleared.
 */

/**
 * Pictures per second in the tests: rendering on the processor is most of a scene's cost. Chosen.
 */
const HERTZ = 20;

/**
 * Limits how often requestAnimationFrame calls its callbacks. Runs in the page, before the page's
 * scripts.
 */
function slowDisplay(hertz) {
  // The shortest interval in milliseconds; it allows for a frame that comes up to half a 60 Hz
  // frame early.
  const least = 1000 / hertz - 1000 / 120;
  const next = window.requestAnimationFrame.bind(window);
  let asked = new Map();
  let count = 0;
  let last = -Infinity;
  const tick = (time) => {
    if (time - last < least) return next(tick);
    last = time;
    const acts = asked;
    asked = new Map();
    for (const act of acts.values())
      try {
        act(time);
      } catch (error) {
        reportError(error);
      }
  };
  window.requestAnimationFrame = (act) => {
    if (asked.size === 0) next(tick);
    asked.set(++count, act);
    return count;
  };
  window.cancelAnimationFrame = (number) => asked.delete(number);
}

/**
 * A display with `hertz` pictures per second by its own clock, `window.clock`, independent of the
 * machine. The next picture is due when the physics worker has answered all requests, so no picture
 * is late, however slow the machine is. With `pause` the display does not wait for the worker, and
 * that many milliseconds of real time lie between pictures.
 */
export function display(hertz, pause = null) {
  return (page) => page.addInitScript(ownDisplay, [hertz, pause]);
}

/** Runs in the page, before the page's scripts. */
function ownDisplay([hertz, pause]) {
  /** The number of requests that the worker has not answered yet. */
  let open = 0;
  const { Worker: Real } = window;
  window.Worker = class extends Real {
    constructor(...settings) {
      super(...settings);
      this.addEventListener("message", ({ data }) => {
        if (data.kind !== "progress") open--;
      });
    }
    postMessage(message, ...more) {
      if (message.kind !== "command") open++;
      super.postMessage(message, ...more);
    }
  };
  let asked = new Map();
  let count = 0;
  window.clock = 0;
  window.requestAnimationFrame = (act) => {
    asked.set(++count, act);
    return count;
  };
  window.cancelAnimationFrame = (number) => asked.delete(number);
  setInterval(() => {
    if (pause === null && open > 0) return;
    window.clock += 1000 / hertz;
    const acts = asked;
    asked = new Map();
    for (const act of acts.values()) act(window.clock);
  }, pause ?? 0);
}

/**
 * Removes the blur behind panels: rendering it on the processor takes as long as the rest of the
 * picture, and no test looks at it. Runs in the page, before the page's scripts.
 */
function withoutBlur() {
  const style = new CSSStyleSheet();
  style.replaceSync(".panel, dialog { backdrop-filter: none !important; isolation: isolate; }");
  document.adoptedStyleSheets.push(style);
}

/**
 * Ends animations and transitions at once: their frames, which come 60 times a second, are an
 * eighth of the cost of opening a page. Tests that look at the page while something glides set a
 * duration of their own. Runs in the page, before the page's scripts.
 */
function withoutMotion() {
  const style = new CSSStyleSheet();
  style.replaceSync(
    `*, *::before, *::after {
      animation-duration: 0s !important; animation-delay: 0s !important;
      transition-duration: 0s !important; transition-delay: 0s !important;
    }`,
  );
  document.adoptedStyleSheets.push(style);
}

/** Makes the pictures of a context's pages cheap; call it before any page is opened. */
export async function drawLightly(context) {
  await context.addInitScript(slowDisplay, HERTZ);
  await context.addInitScript(withoutBlur);
}

/**
 * Provides contexts of `browser` for the page at `url`; waits in them time out after `patience`
 * milliseconds.
 */
export function contextsOf(browser, url, patience) {
  /** Contexts that no test uses at present, by their options. */
  const free = new Map();

  async function make(options) {
    const context = await browser.newContext(options);
    context.setDefaultTimeout(patience);
    // The moment at which a first visit's service worker takes control varies; only
    // page/offline.test.mjs tests it.
    await context.addInitScript(() => delete Navigator.prototype.serviceWorker);
    await drawLightly(context);
    await context.addInitScript(withoutMotion);
    return context;
  }

  /**
   * A context with a page of the same origin that stays open, which keeps the browser's process
   * alive.
   */
  async function makeLasting(options) {
    const context = await make(options);
    const stays = await context.newPage();
    await stays.goto(`${url}icon.svg`);
    return { context, stays };
  }

  return {
    /** A new context for one test, which may change it. */
    async own(options) {
      const context = await make(options);
      return { context, giveBack: () => context.close() };
    },

    /**
     * A context that earlier tests may have used. A second one is made while the first is in use.
     */
    async shared(options) {
      const key = JSON.stringify(options);
      const kept = free.get(key) ?? (await makeLasting(options));
      free.delete(key);
      const { context, stays } = kept;
      return {
        context,
        async giveBack() {
          const pages = context.pages().filter((page) => page !== stays);
          await Promise.all(pages.map((page) => page.close()));
          // sessionStorage, such as drafts, ended with its tab.
          await stays.evaluate(() => localStorage.clear());
          if (free.has(key)) await context.close();
          else free.set(key, kept);
        },
      };
    },
  };
}
