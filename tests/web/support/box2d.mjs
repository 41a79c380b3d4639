/**
 * Support for the tests of the page's Box2D side: its bundled sources, and functions for small
 * worlds.
 */
import assert from "node:assert/strict";
import { rmSync } from "node:fs";
import { createRequire } from "node:module";
import { demoWasm, root, thud } from "./package.mjs";

// esbuild is a dependency of Vite.
const require = createRequire(createRequire(`${root}web/package.json`).resolve("vite"));

/**
 * Bundles and imports the sources. `folder` must lie in web/, because their imports of Box2D are
 * relative.
 */
export async function importRival(folder) {
  const bundle = `${folder}/rival-${process.pid}.mjs`;
  const sources = ["follow", "load", "ruler", "world"].map((name) => `box2d/${name}`);
  sources.push(...["hands", "hold", "stage", "watch"].map((name) => `worker/${name}`));
  await require("esbuild").build({
    stdin: {
      contents: sources.map((name) => `export * from "./${name}";`).join(""),
      resolveDir: `${root}web/src`,
    },
    outfile: bundle,
    bundle: true,
    format: "esm",
    external: ["*.mjs"],
  });
  try {
    return await import(bundle);
  } finally {
    rmSync(bundle);
  }
}

export const rivalry = await importRival(`${root}web/generated/rival`);
export const box2d = await rivalry.loadBox2D();
export const engine = await thud.load(demoWasm);

const BLOCK = { halfWidth: 0.5, halfHeight: 0.5 };

/**
 * Builds a watched thud world and its Box2D copy (`rival`), calls `use`, and closes the copy; `use`
 * also gets the return value of `build`.
 */
export function withRival(options, build, use) {
  const world = engine.createWorld(options);
  const known = rivalry.watch(world, options);
  const built = build(world);
  const rival = new rivalry.Box2DWorld(box2d, world, known);
  try {
    use(world, rival, built, known);
  } finally {
    rival.close();
    world.close();
  }
}

// {}) => Steps both engines; `command` is called before each step, after the rival has read the
// world's changes.
export function step(world, rival, steps, command = () => {}) {
  for (let i = 0; i < steps; i++) {
    rival.sync();
    command();
    world.step();
    rival.step();
  }
}

export function addGround(world, terrain = { kind: "flat" }, options = {}) {
  return world.createTerrain(world.createBody(), terrain, options);
}

export function addBall(world, position, options = {}) {
  const { radius = 0.5, velocity, detection, ...material } = options;
  const ball = world.createBody({ kind: "dynamic", position, velocity, detection });
  world.createCircle(ball, { radius, ...material });
  return ball;
}

export function addBox(world, position, angle = 0) {
  const box = world.createBody({ kind: "dynamic", position, angle });
  world.createObb(box, BLOCK);
  return box;
}

export const near = (actual, expected, tolerance, what = "") =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual}, expected ${expected}`);

export const heightOf = (rival, body) => rival.poses()[4 * body.index + 1];
