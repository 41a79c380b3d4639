#!/usr/bin/env node
/**
 * Runs thud-matrix (tests/matrix) as WebAssembly: matrix.mjs node|chromium|firefox thud-matrix.js
 * WORD... The words are the arguments of that program. Files that it reads are copied to its file
 * system before, and files that it writes are copied back. This script prints its output, and ends
 * with its exit code.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

/** The options of thud-matrix whose argument is a file that it reads, or writes. */
const READ = ["--plain", "--continue"];
const WRITTEN = ["--take", "--keep"];

/**
 * Runs the program in a page or in Node.js. It uses nothing outside of itself, since playwright
 * sends it to the page as text; its arguments and result are JSON, with bytes as base64.
 */
async function runMain({ wasm, words, files, written }) {
  const toBytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const toText = (bytes) => {
    let text = "";
    for (let at = 0; at < bytes.length; at += 0x8000)
      text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
    return btoa(text);
  };
  const out = [];
  const errors = [];
  const module = await globalThis.createMatrix({
    wasmBinary: toBytes(wasm),
    print: (line) => out.push(line),
    printErr: (line) => errors.push(line),
  });
  files.forEach((text, i) => module.FS.writeFile(`/in-${i}`, toBytes(text)));
  const code = module.callMain(words);
  const read = (path) => (module.FS.analyzePath(path).exists ? module.FS.readFile(path) : []);
  const results = written.map((_, i) => toText(Uint8Array.from(read(`/out-${i}`))));
  return { code, out, errors, results };
}

/**
 * The argument of runMain: the program, its words with the names of files replaced, the content of
 * the files that it reads, and the paths of those that it writes.
 */
function parse(program, words) {
  const wasm = readFileSync(program.replace(/js$/, "wasm")).toString("base64");
  const task = { wasm, words: [...words], files: [], written: [] };
  words.forEach((word, i) => {
    if (READ.includes(word)) {
      task.words[i + 1] = `/in-${task.files.length}`;
      task.files.push(readFileSync(words[i + 1]).toString("base64"));
    } else if (WRITTEN.includes(word)) {
      task.words[i + 1] = `/out-${task.written.length}`;
      task.written.push(words[i + 1]);
    }
  });
  return task;
}

async function runInNode(program, task) {
  globalThis.createMatrix = createRequire(import.meta.url)(program);
  return runMain(task);
}

async function runInBrowser(browser, program, task) {
  const { launch } = await import("./browser.mjs");
  const visitor = await launch(browser, { webgl: false });
  try {
    const page = await visitor.newPage();
    await page.addScriptTag({ path: program });
    return await page.evaluate(runMain, task);
  } finally {
    await visitor.close();
  }
}

const [place, file, ...words] = process.argv.slice(2);
const program = resolve(file);
const task = parse(program, words);
const done =
  place === "node" ? await runInNode(program, task) : await runInBrowser(place, program, task);
for (const line of done.out) console.log(line);
for (const line of done.errors) console.error(line);
task.written.forEach((to, i) => writeFileSync(to, Buffer.from(done.results[i], "base64")));
process.exitCode = done.code;
