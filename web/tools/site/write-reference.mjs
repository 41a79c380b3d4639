#!/usr/bin/env node
/**
 * Writes the pages of the site that are made of other files: the reference, site/c-*.md and so on, and
 * the pages of bindings. They are not kept in the repository.
 */
import { readdirSync, rmSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { bindingPages } from "./binding-pages.mjs";
import { cPages } from "./c-reference.mjs";
import { jsPages } from "./js-reference.mjs";
import { pythonPages } from "./python-reference.mjs";

const SITE = fileURLToPath(new URL("../../site/", import.meta.url));
const HEAD = "---\noutline: [2, 3]\npageClass: reference\n---\n\n";

for (const name of readdirSync(SITE).filter((one) => /^(c|js|python|binding)-.*\.md$/.test(one))) rmSync(SITE + name);
for (const [name, text] of [...cPages(), ...jsPages(), ...pythonPages()]) writeFileSync(`${SITE}${name}.md`, HEAD + text);
for (const [name, text] of bindingPages()) writeFileSync(`${SITE}${name}.md`, text);
