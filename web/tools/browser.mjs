/**
 * Launches the browsers that the system has, for tests and screenshots, through playwright-core:
 * Chromium by the DevTools protocol, Firefox by WebDriver BiDi, which an unpatched Firefox
 * supports.
 */
import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium, firefox } from "playwright-core";
import { listenFrom } from "./serve.mjs";
import { createStaticServer } from "./static-server.mjs";

/** Screens of visitors, as options of a browser context. */
export const DESKTOP = { viewport: { width: 1440, height: 900 } };
export const PHONE = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};

/**
 * The names of the executables of each browser; the first is also the name of Debian's package. The
 * first of Chromium is the same browser without the parts that draw its windows, which takes half of
 * the processor time for the same tests.
 */
const NAMES = {
  chromium: [
    "chromium-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
  ],
  firefox: ["firefox-esr", "firefox"],
};

/** The browsers that the page is tested in. */
export const BROWSERS = Object.keys(NAMES);

/**
 * The path of a browser's executable: from the environment variable CHROMIUM or FIREFOX, or else
 * the first in PATH. Throws where there is none.
 */
function find(browser) {
  const chosen = process.env[browser.toUpperCase()];
  if (chosen) return chosen;
  for (const folder of (process.env.PATH ?? "").split(delimiter))
    for (const name of NAMES[browser])
      try {
        accessSync(join(folder, name), constants.X_OK);
        return join(folder, name);
      } catch {
        // This name is not in this folder: try the next.
      }
  const [first] = NAMES[browser];
  throw new Error(`no ${browser} found on the path; on Debian: apt-get install ${first}`);
}

/**
 * Launches a browser without a window and without network traffic of its own. `webgl`: with WebGL,
 * which the processor renders in Chromium. `oneProcess`: in Chromium all pages of a host in a
 * context share a process, and the code that it has compiled.
 */
export function launch(browser, options) {
  return browser === "firefox" ? launchFirefox(options) : launchChromium(options);
}

export function launchFirefox({ webgl = true } = {}) {
  return firefox.launch({
    channel: "moz-firefox",
    executablePath: find("firefox"),
    headless: true,
    firefoxUserPrefs: { "webgl.disabled": !webgl },
  });
}

export function launchChromium({ webgl = true, oneProcess = false } = {}) {
  return chromium.launch({
    executablePath: find("chromium"),
    headless: true,
    args: [
      "--no-sandbox",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      ...(oneProcess ? ["--process-per-site"] : []),
      ...(webgl
        ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        : ["--disable-gpu", "--disable-3d-apis"]),
    ],
  });
}

/**
 * Serves the built page on a free port, under the path `under`. Returns its URL, and `close`.
 * `prepare` is called with the server before it listens.
 */
export async function servePage(under = "/", prepare = () => {}) {
  const server = createStaticServer(fileURLToPath(new URL("../dist", import.meta.url)), under);
  prepare(server);
  const port = await listenFrom(server, 0);
  return {
    url: `http://127.0.0.1:${port}${under}`,
    close: () => {
      server.closeAllConnections();
      return new Promise((done) => server.close(done));
    },
  };
}

/**
 * Runs `count` steps of the page's scene by the key of the single step, and waits until the last
 * has been run. Waits first until a scene has been built.
 */
export async function stepBy(page, count) {
  await page.waitForFunction(() => document.title.endsWith(" · thud"));
  const hud = page.locator("#hud");
  const before = await hud.evaluate(({ dataset }) => Number(dataset.steps ?? 0));
  await page.evaluate((presses) => {
    for (let i = 0; i < presses; i++)
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: ".", bubbles: true }));
  }, count);
  await page.waitForFunction(
    (least) => Number(document.querySelector("#hud").dataset.steps) >= least,
    before + count,
  );
}
