/**
 * The documentation site: VitePress builds it into dist/docs, beside the page. All its pages are in
 * one folder, so that relative links between them are right wherever the folder is served.
 */
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitepress";
import { codeNames } from "../../tools/code-names.mjs";
import { liveFences } from "../../tools/site/live-fences.mjs";
import { anyFolder, strictPolicy } from "../../tools/site/static.mjs";
import { dark, light } from "./code-colours.mjs";
import { sidebar } from "./sidebar.mjs";

const path = (name) => fileURLToPath(new URL(name, import.meta.url));

export default defineConfig({
  title: "thud",
  titleTemplate: ":title · thud",
  description: "How to use thud, a physics engine for 2D games, in C, JavaScript and Python.",
  lang: "en",
  base: "./",
  outDir: path("../../dist/docs"),
  cacheDir: path("../../generated/site"),
  metaChunk: true,
  // A page is loaded when it is asked for.
  router: { prefetchLinks: false },
  appearance: { storageKey: "thud-theme" },
  head: [
    ["link", { rel: "icon", href: "../icon.svg", type: "image/svg+xml" }],
    ["meta", { name: "color-scheme", content: "dark light" }],
    ["meta", { name: "theme-color", content: "#0b0f17", media: "(prefers-color-scheme: dark)" }],
    ["meta", { name: "theme-color", content: "#eef0f3", media: "(prefers-color-scheme: light)" }],
  ],
  markdown: {
    theme: { dark, light },
    config: liveFences,
  },
  themeConfig: {
    siteTitle: "thud",
    logo: { src: "../icon.svg", alt: "" },
    nav: [
      { text: "Begin", link: "/begin-javascript", activeMatch: "/(begin|binding)-" },
      { text: "Guides", link: "/guide-units", activeMatch: "/guide-" },
      { text: "Reference", link: "/reference-c", activeMatch: "/(reference-|c-|js-|python-|errors)" },
      { text: "Play", link: "../", target: "_self", noIcon: true },
    ],
    sidebar,
    outline: [2, 3],
    search: { provider: "local" },
    docFooter: { prev: "Before", next: "Next" },
    externalLinkIcon: true,
  },
  transformHtml: strictPolicy,
  vite: {
    plugins: [codeNames(), anyFolder()],
    publicDir: path("../public"),
    worker: { format: "es" },
    build: {
      target: "es2022",
      // The content security policy allows no data: URLs of scripts.
      assetsInlineLimit: 0,
      // The editor and the engine are loaded when a reader asks for them.
      chunkSizeWarningLimit: 800,
    },
  },
});
