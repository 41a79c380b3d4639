/**
 * Contexts of a browser that serve one test after another. A second page of the same context, in a
 * process that is still there, compiles neither the page's scripts nor the engine again, which is
 * most of what opening it costs. It finds nothing that the first has left behind but that.
 */

/** Pictures a second of the tests' display: to draw by software is most of what a scene costs. */
const HERTZ = 30;

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
 * A display of so many pictures a second by its own clock, `window.clock`, whatever the machine's is:
 * no picture is late, and a scene is in time, however slow the machine is. There are so many
 * milliseconds from one to the next in truth.
 */
export function display(hertz, pause) {
  return (page) =>
    page.addInitScript(
      ([rate, milliseconds]) => {
        let asked = new Map();
        let count = 0;
        window.clock = 0;
        window.requestAnimationFrame = (act) => {
          asked.set(++count, act);
          return count;
        };
        window.cancelAnimationFrame = (number) => asked.delete(number);
        setInterval(() => {
          window.clock += 1000 / rate;
          const acts = asked;
          asked = new Map();
          for (const act of acts.values()) act(window.clock);
        }, milliseconds);
      },
      [hertz, pause],
    );
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
    await context.addInitScript(slowDisplay, HERTZ);
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
