/** Runs every `@example` of the typings, each in a world of its own. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const engine = await thud.load();
const dist = `${root}web/package/dist/`;
const AsyncFunction = (async () => {}).constructor;

/** The examples: file, text, and the interface, method or function that each belongs to. */
function readExamples() {
  const files = readdirSync(dist, { recursive: true }).filter((file) => file.endsWith(".d.ts"));
  return files.flatMap((file) => {
    const text = readFileSync(`${dist}${file}`, "utf8");
    const found = [...text.matchAll(/@example (.*)\n/g)];
    assert.equal(found.length, text.split("@example").length - 1, `${file}: an example is one line`);
    return found.map((match) => {
      const before = text.slice(0, match.index);
      const own = /^export (?:declare )?interface (\w+)/.exec(text.slice(match.index).split("*/\n")[1] ?? "");
      const around = [...before.matchAll(/^export (?:declare )?(?:interface|class) (\w+)/gm)].at(-1);
      return { file, of: own?.[1] ?? around?.[1] ?? "", text: match[1] };
    });
  });
}

/** The variables that the examples use. */
function makeSetting() {
  const world = engine.createWorld();
  const dynamic = { kind: "dynamic", shapes: [{ kind: "circle", radius: 0.5 }] };
  const spawn = (x, rest) => world.createBody({ ...dynamic, position: [x, 5], ...rest });
  const ground = world.createBody();
  const body = world.createBody();
  const heights = [0, 0, 1, 0, 0];
  const line = { kind: "uniform", x0: -2, spacing: 1, heights };
  const shape = world.createTerrain(world.createBody({ position: [500, 0] }), line);
  const [ball, gun, bodyA, bodyB] = [0, 2, 4, 6].map((x) => spawn(x));
  const frameless = { kind: "hinge", bodyA: ground, bodyB, at: [6, 5] };
  const joint = world.createJoint(frameless);
  const sensor = { kind: "circle", radius: 1, sensor: true };
  const [goal] = world.shapesOf(world.createBody({ position: [0, 5], shapes: [sensor] }));
  const [balloon] = world.shapesOf(spawn(10));
  const [PLANK, PLAYER, BALL, BRICK] = [2, 4, 8, 16];
  world.step();
  const calls = [];
  const call = (name) => (...args) => calls.push([name, args]);
  return {
    ...thud,
    calls,
    world,
    ball,
    ground,
    body,
    heights,
    shape,
    gun,
    bodyA,
    bodyB,
    joint,
    jointA: world.createJoint({ kind: "hinge", bodyA: ground, bodyB: bodyA, at: [4, 5] }),
    jointB: joint,
    goal,
    balloon,
    PLANK,
    PLAYER,
    BALL,
    BRICK,
    ballOptions: dynamic,
    boat: ball,
    rocket: ball,
    flag: ball,
    car: ball,
    platform: body,
    paddle: ball,
    lift: world.createBody({ kind: "kinematic" }),
    debris: balloon,
    ghost: balloon,
    ice: balloon,
    belt: balloon,
    point: [0, 5],
    nozzle: [0, 4.5],
    eye: [0, 9],
    way: [0, -9],
    x: 500,
    y: 0,
    angle: 0.5,
    time: 1,
    isPressed: true,
    pointer: { x: 1, y: 2 },
    number: thud.numberOf(ball),
    numbers: new Float64Array(6),
    hit: Object.assign([], { a: balloon, b: goal }),
    hero: new thud.Mover(world, { shape: { kind: "circle", radius: 0.5 }, position: [30, 3] }),
    isGlass: () => false,
    ...Object.fromEntries(["redraw", "score", "shoot", "pick", "look", "veto"].map((name) => [name, call(name)])),
  };
}

const joint = (kind, rest) => `world.createJoint({ kind: "${kind}", bodyA, bodyB, ${rest} })`;
const shape = (rest) => `world.createBody({ kind: "dynamic", shapes: [{ ${rest} }] })`;

/** For each interface of options, how an example with one of its options becomes a call. */
const MAKERS = {
  WorldOptions: (text) => `world.engine.createWorld({ ${text} }).close()`,
  BodyOptions: (text) => `world.createBody({ kind: "dynamic", ${text} })`,
  ShapeOptions: (text) => shape(`kind: "circle", radius: 1, ${text}`),
  CircleOptions: (text) => shape(`kind: "circle", radius: 1, ${text}`),
  BoxOptions: (text) => shape(`kind: "aabb", halfWidth: 1, halfHeight: 1, ${text}`),
  Drive: (text) => joint("slider", `at: [4, 5], along: { ${text} }`),
  JointOptions: (text) => joint("hinge", `at: [4, 5], ${text}`),
  PairOptions: (text) => joint("hinge", `at: [4, 5], ${text}`),
  PlacedOptions: (text) => joint("slider", `at: [4, 5], ${text}`),
  DistanceOptions: (text) => joint("distance", text),
  HingeOptions: (text) => joint("hinge", `at: [4, 5], ${text}`),
  WheelOptions: (text) => joint("wheel", `at: [4, 5], ${text}`),
  SliderOptions: (text) => joint("slider", `at: [4, 5], ${text}`),
};

// A program that runs the example; an option becomes part of a call.
function programOf({ of, text }) {
  if (/^\{ kind: /.test(text)) return `world.createJoint(${text})`;
  if (!/^\w+: /.test(text)) return text;
  assert.ok(MAKERS[of], `an option of ${of}: ${text}`);
  return MAKERS[of](text);
}

const examples = readExamples();

test("examples_are_found", () => assert.ok(examples.length > 80, `${examples.length}`));

for (const [i, example] of examples.entries())
  test(`example_${i}_of_${example.file}_runs_${example.text.replace(/\W+/g, "_").slice(0, 60)}`, async () => {
    const setting = makeSetting();
    // A loop may have no iterations, so the methods' existence is checked separately.
    for (const [, name] of example.text.matchAll(/\bworld\.(\w+)/g))
      assert.equal(typeof setting.world[name], "function", `world.${name}`);
    // A variable that the example declares itself is not passed in.
    const isNew = (name) => new RegExp(`const [^=]*\\b${name}\\b.*=`).test(example.text);
    const names = Object.keys(setting).filter((name) => !isNew(name));
    const run = new AsyncFunction(...names, programOf(example));
    try {
      await run(...names.map((name) => setting[name]));
      setting.world.step();
    } finally {
      setting.world.close();
    }
  });
