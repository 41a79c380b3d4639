/** Tests of `load`: what a host may send, and modules that are not thud's. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const bytes = readFileSync(`${root}web/package/dist/thud.wasm`);

test("response_is_loaded_whatever_parameters_its_content_type_has", async () => {
  for (const type of ["application/wasm", "application/wasm; charset=utf-8", "text/plain"]) {
    const engine = await thud.load(new Response(bytes, { headers: { "content-type": type } }));
    engine.createWorld().close();
  }
});

test("load_of_module_with_other_imports_throws_load_error", async () => {
  // (module (import "a" "b" (func)))
  const type = [1, 4, 1, 0x60, 0, 0];
  const imports = [2, 7, 1, 1, 0x61, 1, 0x62, 0, 0];
  const module = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, ...type, ...imports]);
  await assert.rejects(thud.load(module), { name: "ThudError", code: "load" });
});
