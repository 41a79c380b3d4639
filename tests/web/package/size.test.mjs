/**
 * Measures the linked size of small programs, built for size, that use more and more of the engine.
 * The bounds are the sizes that are reached, so that an increase is noticed; the aims stand beside
 * them.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { buildLinkage } from "../support/linkage.mjs";
import { root, thud } from "../support/package.mjs";

/** Kilobytes (1000 bytes) of the gzipped module: the bound that is reached, and the aim. */
const PROGRAMS = [
  // Circles, boxes, islands and joints begin from thud_default_small_world_def. What it leaves out of
  // each: sensors, 3 kB; the grid, 4.1 kB, for which testing all pairs takes 1 kB; sleep, 1.2 kB;
  // restitution, 1.1 kB; the errors of steps, 0.7 to 1 kB; the time budget, changes of terrain and the
  // search for the few resting shapes near what moves, 0.6 kB.
  // Numbers in the reasons of refusals take 0.7 to 0.9 kB of each, and the exact path of what is free,
  // with its damping, 0.9 kB. The choice of a detection's island solver and of the islands that it
  // holds takes 20 to 130 bytes. Counts of the broadphase, cells by hand, textured ground and decided
  // velocities, of which a step asks whether they are there, take 0.5 kB. That a world has an array
  // for arrivals under swept takes 3 to 31 bytes. That the shapes at rest stay sorted while bodies
  // fall asleep and wake beside them takes 0.2 to 0.4 kB.
  { name: "circles", bound: 33.5, aim: 12 },
  { name: "boxes", bound: 47.0, aim: 18 },
  // The limit of direct islands in motion takes 0.1 kB here, of everything and of joints.
  { name: "islands", bound: 45.6, aim: 18 },
  // Queries that leave edits pending, and reasons of refusals, take 2 kB. Sensors that look near by in
  // a grid of boxes, so that many of them cost no square of their number, take 0.7 kB.
  { name: "everything", bound: 93.9, aim: 40 },
  // Joint rows that are solved together, both limits and the bracing of torn joints take 5 kB,
  // joints that yield to static shapes 3 kB, and the common cap of both directions 0.6 kB. Trees of
  // joints that are solved from their ends take 1.8 kB, and their solution without a matrix, with
  // closing gaps that add no energy, 5.1 kB more; parts of a step whose length each tree chooses, and
  // Newton steps that end at the minimum on their way, 1.1 kB. That bracing leaves large groups some
  // energy, and groups without a torn joint alone, takes 0.1 kB here; that it is plugged in with joints
  // takes 0.1 kB off every other program.
  { name: "joints", bound: 88.5, aim: 40 },
];

const sources = readdirSync(`${root}engine/src`, { recursive: true })
  .filter((name) => name.endsWith(".c"))
  .sort()
  .map((name) => `${root}engine/src/${name}`);
const build = `${root}build/link`;
const table = [];
rmSync(build, { recursive: true, force: true });
mkdirSync(build, { recursive: true });

function emcc(words) {
  const helpers = existsSync("/usr/share/nodejs") ? "/usr/share/nodejs" : "";
  // Every browser that has SIMD has the other three features, too.
  const features = "-msimd128 -mbulk-memory -mnontrapping-fptoint -msign-ext";
  const flags = "-Oz -std=gnu17 -DNDEBUG -DTD_ISA=base -ffp-contract=off -fno-math-errno";
  execFileSync(
    "emcc",
    [
      ...`${flags} ${features} -ffunction-sections -fdata-sections -w`.split(" "),
      `-I${root}engine/include`,
      `-I${root}engine/src`,
      ...words,
    ],
    // emcc writes objects to its working directory.
    {
      cwd: build,
      env: { ...process.env, NODE_PATH: helpers },
      stdio: ["ignore", "ignore", "inherit"],
    },
  );
}

/** Compiles the whole engine once, for all programs. */
before(() => emcc(["-c", ...sources]));

function link(name) {
  const linking = "--no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sMALLOC=emmalloc";
  // Files of one folder side by side: what is alike compresses best where it is near.
  const objects = sources.map((file) => basename(file).replace(/c$/, "o"));
  const program = `${root}tests/web/link/${name}.c`;
  emcc([...linking.split(" "), program, ...objects, "-o", `${name}.wasm`]);
  return readFileSync(join(build, `${name}.wasm`));
}

async function run(bytes) {
  const imports = { env: { emscripten_notify_memory_growth() {} }, wasi_snapshot_preview1: {} };
  for (const { module, name } of WebAssembly.Module.imports(new WebAssembly.Module(bytes)))
    (imports[module] ??= {})[name] ??= () => 0;
  const { instance } = await WebAssembly.instantiate(bytes, imports);
  instance.exports._initialize();
  return instance.exports;
}

const STEPS = 240;

function hashOf(program) {
  const half = (upper) => program.linkage_hash(STEPS, upper).toString(16).padStart(8, "0");
  return half(1) + half(0);
}

/** The hash of the same linkage built with the package. */
async function linkageHash() {
  const { world } = buildLinkage((await thud.load()).createWorld());
  for (let i = 0; i < STEPS; i++) world.step();
  const hash = world.hash();
  world.close();
  return hash;
}

for (const { name, bound, aim } of PROGRAMS)
  test(`program_of_${name}_behaves_and_links_no_more_than_${bound}_kB`, async () => {
    const bytes = link(name);
    const zipped = gzipSync(bytes, { level: 9 }).length;
    table.push(
      `${name.padEnd(11)} ${bytes.length} bytes, ${zipped} gzipped; bound ${bound} kB, aim ${aim}`,
    );
    const imports = WebAssembly.Module.imports(new WebAssembly.Module(bytes));
    assert.ok(!imports.some(({ name }) => name === "fd_write"), "the C library's output is linked");
    const made = await run(bytes);
    assert.ok(Math.abs(made.circle_height(300) - 0.5) < 0.02);
    if (made.box_height) assert.ok(Math.abs(made.box_height(300) - 0.5) < 0.02);
    if (made.oriented_height) assert.ok(Math.abs(made.oriented_height(300) - 0.5) < 0.02);
    if (made.ray_fraction) assert.ok(Math.abs(made.ray_fraction() - 0.5) < 1e-6);
    if (made.linkage_hash) assert.equal(hashOf(made), await linkageHash());
    assert.ok(zipped <= bound * 1000, `${name}: ${zipped} bytes`);
  });

after(() => console.log(`\nlinked for size:\n${table.join("\n")}`));
