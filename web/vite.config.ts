import { defineConfig } from "vite";

export default defineConfig({
  // Relative addresses: the built folder can be served from anywhere.
  base: "./",
  build: {
    target: "es2022",
    // The content security policy allows neither inline scripts nor data: addresses.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  server: { fs: { allow: [".."] } },
});
