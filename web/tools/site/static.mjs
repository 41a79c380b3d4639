/** What makes the built site run in any folder of any static host, under a strict policy. */

/**
 * A plugin of Vite: the site's scripts find out where the site is from their own address, in place
 * of a path that is fixed when the site is built. In pages, which are all in one folder, addresses
 * are relative.
 */
export function anyFolder() {
  return {
    name: "any-folder",
    enforce: "pre",
    apply: "build",
    transform(code, id, { ssr } = {}) {
      if (ssr) return null;
      if (id === "/@siteData") {
        const base = 'new URL(import.meta.url.replace(/assets\\/.*$/, "")).pathname';
        return { code: `export default { ...window.__VP_SITE_DATA__, base: ${base} };`, map: null };
      }
      if (!id.endsWith("/vitepress/dist/client/app/utils.js")) return null;
      const fixed = "const base = import.meta.env.BASE_URL;";
      if (!code.includes(fixed)) throw new Error(`${id} has changed: it lacks "${fixed}"`);
      return { code: code.replace(fixed, "const { base } = siteDataRef.value;"), map: null };
    },
  };
}

/** Scripts of this host alone, none in the page, and none made of text but WebAssembly. */
const POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; " +
  "img-src 'self' data:; connect-src 'self'; worker-src 'self'; frame-src 'self'; base-uri 'none'; form-action 'none'";

/** VitePress' scripts in the page, in place of which public/theme.js is loaded. */
const INLINE = /<script id="check-(?:dark-mode|mac-os)">.*?<\/script>/gs;

/** Gives a page of the site its policy, and takes out its inline scripts. */
export function strictPolicy(html) {
  const meta = `<meta http-equiv="Content-Security-Policy" content="${POLICY}">`;
  const changed = html
    .replace(INLINE, "")
    .replace('<meta charset="utf-8">', (charset) => `${charset}\n    ${meta}\n    <script src="./theme.js"></script>`);
  if (/<script(?![^>]* src=)/.test(changed)) throw new Error("a page has an inline script");
  return changed;
}
