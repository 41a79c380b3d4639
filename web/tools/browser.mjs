/**
 * The system's browsers for tests and screenshots, driven by playwright-core: Chromium by its own
 * protocol, Firefox by WebDriver BiDi, which Firefox as it comes understands.
 */
import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium, firefox } from "playwright-core";
import { listenFrom } from "./serve.mjs";
import { createStaticServer } from "./static-server.mjs";

/** A visitor's screen, as options of a browser's context. */
export const DESKTOP = { viewport: { width: 1440, height: 900 } };
export const PHONE = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};

/** What each is called on the path; the first is Debian's package too. */
const NAMES = {
  chromium: ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"],
  firefox: ["firefox-esr", "firefox"],
};

/** The browsers that the page is tested in. */
export const BROWSERS = Object.keys(NAMES);

/** CHROMIUM and FIREFOX name another one than the first on the path. */
function find(browser) {
  const chosen = process.env[browser.toUpperCase()];
  if (chosen) return chosen;
  for (const folder of (process.env.PATH ?? "").split(delimiter))
    for (const name of NAMES[browser])
      try {
        accessSync(join(folder, name), constants.X_OK);
        return join(folder, name);
      } catch {
        // Not there: the next one.
      }
  const [first] = NAMES[browser];
  throw new Error(`no ${browser} found on the path; on Debian: apt-get install ${first}`);
}

/**
 * Headless, and quiet towards the network; with `webgl` it draws by software. With `oneProcess` all
 * pages of a host in one context share a process in Chromium, and what that has compiled.
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

/** Serves the built page on some free port, at the root or another path. */
export async function servePage(under = "/") {
  const server = createStaticServer(fileURLToPath(new URL("../dist", import.meta.url)), under);
  const port = await listenFrom(server, 0);
  return {
    url: `http://127.0.0.1:${port}${under}`,
    close: () => {
      server.closeAllConnections();
      return new Promise((done) => server.close(done));
    },
  };
}

/** Makes steps by the key for a single one, once a scene is there, and waits for the last. */
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
