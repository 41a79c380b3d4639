/**
 * Contexts of a browser that serve one test after another. A second page of the same context, in a
 * process that is still there, compiles neither the page's scripts nor the engine again, which is
 * most of what opening it costs. It finds nothing that the first has left behind but that.
 */

/** Pictures a second of the tests' display: to draw by software is most of what a scene costs. */
const HERTZ = 20;

/** Calls what asks for pictures only so often. Runs in the page, before its own scripts. */
function slowDisplay(hertz) {
  // A display's pictures come a little early or late.
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
 * A display of so many pictures a second by its own clock, `window.clock`, whatever the machine's is.
 * The next picture is due when the physics worker has answered all that it was asked: no picture is
 * late, and a scene is in time, however slow the machine is. With `pause` it waits for nobody, and
 * there are so many milliseconds from one to the next in truth.
 */
export function display(hertz, pause = null) {
  return (page) => page.addInitScript(ownDisplay, [hertz, pause]);
}

/** Runs in the page, before its own scripts. */
function ownDisplay([hertz, pause]) {
  /** What the worker has not answered yet. */
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
 * Panels let the scene shine through them blurred: by software that is as much work as all else of a
 * picture, and no test looks at it. Runs in the page, before its own scripts.
 */
function withoutBlur() {
  const style = new CSSStyleSheet();
  style.replaceSync(".panel, dialog { backdrop-filter: none !important; isolation: isolate; }");
  document.adoptedStyleSheets.push(style);
}

/** Makes pictures of a context's pages cheap: before any page of it is opened. */
export async function drawLightly(context) {
  await context.addInitScript(slowDisplay, HERTZ);
  await context.addInitScript(withoutBlur);
}

/** Takes contexts of `browser` for the page at `url`, whose waits may take so many milliseconds. */
export function contextsOf(browser, url, patience) {
  /** Contexts that no test has at present, by their options. */
  const free = new Map();

  async function make(options) {
    const context = await browser.newContext(options);
    context.setDefaultTimeout(patience);
    // When a first visit's service worker takes over is chance: page/offline.test.mjs waits for it.
    await context.addInitScript(() => delete Navigator.prototype.serviceWorker);
    await drawLightly(context);
    return context;
  }

  /** With a page of the same origin that stays: with it stays the process. */
  async function makeLasting(options) {
    const context = await make(options);
    const stays = await context.newPage();
    await stays.goto(`${url}icon.svg`);
    return { context, stays };
  }

  return {
    /** A context of a test's own, to change as it likes. */
    async own(options) {
      const context = await make(options);
      return { context, giveBack: () => context.close() };
    },

    /** One that an earlier test may have had. Who needs two at once gets two. */
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
          // What is kept for one tab, such as drafts, went with it.
          await stays.evaluate(() => localStorage.clear());
          if (free.has(key)) await context.close();
          else free.set(key, kept);
        },
      };
    },
  };
}
