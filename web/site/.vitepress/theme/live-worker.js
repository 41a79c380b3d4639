/**
 * Runs an example in a worker: code as one would write it on the package. Whatever world it makes
 * last is shown. Once a picture its function `frame` is called with the seconds that have passed;
 * where it has none, the world is advanced by them. Programs of other engines run too, and are
 * loaded when one imports them (rivals.js).
 */
import * as thud from "thud";
import * as geometry from "thud/geometry";

/** What of its distance from the pointer a grabbed body covers in a second, times. Chosen. */
const PULL = 10;

let world = null;
let frame = null;
/** The body that the reader drags. */
let held = null;

/** The engine that records, which examples name as it lies in a project. */
const RECORDED = /\bthud-recorded\.wasm$/;
const recordedUrl = new URL("../../../package/dist/thud-recorded.wasm", import.meta.url);

/** `load` of the package, with engines that remember the world that was made last. */
async function load(...sources) {
  const engine = await thud.load(...(RECORDED.test(sources[0]) ? [recordedUrl] : sources));
  const createWorld = engine.createWorld.bind(engine);
  engine.createWorld = (options) => (world = createWorld(options));
  return engine;
}

/** What shows a world of another engine and advances it; null: the world is thud's. */
let rival = null;

const bringRival = async (name) => (await import("./rivals.js"))[name]((shown) => (world = rival = shown));

/** "thud/recording", with players whose world is shown. */
async function bringRecording() {
  const recording = await import("thud/recording");
  class Player extends recording.Player {
    constructor(...given) {
      super(...given);
      world = this.world;
    }
  }
  return { ...recording, Player };
}

const MODULES = {
  thud: async () => ({ ...thud, load }),
  "thud/recording": bringRecording,
  "thud/geometry": async () => geometry,
  planck: () => bringRival("planck"),
  "matter-js": () => bringRival("matter"),
  chipmunk: () => bringRival("chipmunk"),
  "@dimforge/rapier2d-compat": async () => (await import("./rapier.js")).rapier((shown) => (world = rival = shown)),
};

/** An import of names, or of a default, from one of MODULES, at the beginning of a line. */
const IMPORT = /^import\s+(\{[^}]*\}|\w+)\s+from\s+"([^"]+)";?/gm;

const say = (value) =>
  typeof value === "string" ? value : value instanceof Error ? String(value) : JSON.stringify(value);

const printer = { log: (...values) => postMessage({ printed: values.map(say).join(" ") }) };

/** Runs the code and keeps its function `frame`. */
async function start(code) {
  const body = code.replace(IMPORT, (_, names, from) => {
    if (!(from in MODULES)) throw new Error(`examples here have no module "${from}"`);
    return `const ${names.replace(/\bas\b/g, ":")} = await modules["${from}"]();`;
  });
  const AsyncFunction = start.constructor;
  const run = new AsyncFunction(
    "modules",
    "console",
    `"use strict";${body}\n;return typeof frame === "function" ? frame : null;`,
  );
  frame = await run(MODULES, printer);
}

/** Moves the body under the reader's pointer after it; null: lets go. */
function follow(place) {
  if (!place || (held && !world.isValid(held))) held = null;
  if (!place) return;
  if (!held) {
    const met = world.closest(place, 0);
    held = met && world.bodyOf(met.shape);
  }
  if (!held) return;
  const { kind, position } = world.bodyStateOf(held);
  if (kind !== "dynamic") return;
  world.setVelocity(held, [PULL * (place[0] - position[0]), PULL * (place[1] - position[1])]);
}

function show({ seconds, lower, upper, hand: place }) {
  if (!world) return {};
  if (rival) {
    if (seconds > 0) rival.advance(seconds);
    return rival.draw();
  }
  follow(place);
  if (seconds > 0) {
    if (frame) frame(seconds);
    else world.advance(seconds);
  }
  const lists = world.draw({ shapes: true, joints: true, lower, upper });
  return { shapes: lists.shapes.slice(), lines: lists.lines.slice() };
}

let began = Promise.resolve();
addEventListener("message", ({ data }) => {
  // Answered at once, also while the code waits for a download.
  if (data.answer) return postMessage({ answered: true });
  began = began.then(async () => {
    try {
      postMessage(data.code === undefined ? show(data) : (await start(data.code), {}));
    } catch (error) {
      postMessage({ failed: String(error?.message ?? error) });
    }
  });
});
// The first answer: from here on the page asks.
postMessage({ answered: true });
