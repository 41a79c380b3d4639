/**
 * What a scene's text can use: for the list beside the code and for completion. Typed by what it
 * describes, so that a name that is new or gone does not compile.
 */
import type { BodyOptions, CircleOptions, ObbOptions, World, WorldOptions } from "thud";
import type { Input, Mark, Paint, Scene, SceneSetting } from "../../scene/scene";

/** An example or form, and what it does. */
export type Entry = readonly [example: string, meaning: string];

const SETTING: Record<keyof SceneSetting, Entry> = {
  createWorld: [
    "const world = createWorld({ gravity: [0, -10] })",
    "A world; units are yours, y is up.",
  ],
  size: [
    "for (let i = 0; i < size; i++)",
    "How many: the visitor's number; export const size says its range.",
  ],
  seed: ["random(seed)", "The visitor's random seed."],
  random: [
    "const chance = random(seed); chance(-1, 1)",
    "Numbers between two bounds, the same on every machine.",
  ],
  grid: ["grid(x)", "The nearest multiple of 1/65536."],
  readText: ['await readText("levels/quarry.tmj")', "The text of a file of this page."],
  readLevel: ["await readLevel(name, text)", "Reads a map of the Tiled editor."],
  buildLevel: ["const world = buildLevel(level)", "The world of such a map."],
  createMover: [
    'createMover(world, { shape: { kind: "circle", radius: 0.4 }, position: [0, 2] })',
    "Moves a game's character over ground.",
  ],
  thud: ["thud.createWorld()", "The engine itself, without the visitor's choices."],
};

const WORLD_OPTIONS: Partial<Record<keyof WorldOptions, Entry>> = {
  gravity: ["gravity: [0, -10]", "Length per second squared."],
  timeStep: ["timeStep: 1 / 60", "Seconds."],
  lengthScale: ["lengthScale: 1", "The size of a typical body."],
  sleeping: ["sleeping: true", "Bodies at rest may sleep."],
  maximumSpeed: ["maximumSpeed: 400", "In length scales per second."],
};

const WORLD: Partial<Record<keyof World, Entry>> = {
  createBody: [
    'const ball = world.createBody({ kind: "dynamic", position: [0, 5] })',
    "Static unless it says dynamic or kinematic.",
  ],
  createCircle: [
    "world.createCircle(ball, { radius: 0.5, restitution: 0.4 })",
    "Gives a body a circle.",
  ],
  createObb: ["world.createObb(body, { halfWidth: 1, halfHeight: 0.5 })", "A box that turns."],
  createAabb: [
    "world.createAabb(ground, { halfWidth: 10, halfHeight: 1 })",
    "A box that never turns.",
  ],
  createTerrain: [
    'world.createTerrain(body, { kind: "uniform", x0: 0, spacing: 1, heights })',
    "Ground of any length, solid below.",
  ],
  dig: ["world.dig(shape, [x, y], 2)", "Takes a circle out of terrain."],
  bodyState: ["world.bodyState(ball).position", "Where it is, how fast, its mass."],
  setVelocity: ["world.setVelocity(ball, [3, 0])", "And, third, radians per second."],
  setTransform: ["world.setTransform(ball, [0, 5], 0)", "Puts it elsewhere."],
  applyImpulse: ["world.applyImpulse(ball, [0, 5], point)", "Mass times speed, at a point."],
  applyForce: ["world.applyForce(ball, [10, 0])", "Through the next step."],
  destroy: ["world.destroy(ball)", "Removes a body or a shape."],
  castRay: ["world.castRay([0, 10], [0, -20])", "The first shape on the way, or null."],
  overlap: ['world.overlap({ kind: "circle", center: [0, 0], radius: 1 })', "Shapes in a place."],
  events: ["world.events().hit", "What touched, left and hit in the last step."],
  setGravity: ["world.setGravity([0, 10])", "From the next step on."],
};

const BODY: Partial<Record<keyof BodyOptions, Entry>> = {
  kind: ['kind: "dynamic"', "Or static, or kinematic: moves, and nothing moves it."],
  position: ["position: [0, 5]", ""],
  angle: ["angle: 0.5", "Radians."],
  velocity: ["velocity: [3, 0]", ""],
  angularVelocity: ["angularVelocity: 2", "Radians per second."],
  gravityScale: ["gravityScale: 0", "0 floats."],
  fixedRotation: ["fixedRotation: true", ""],
};

const SHAPE: Partial<Record<keyof (CircleOptions & ObbOptions), Entry>> = {
  radius: ["radius: 0.5", "Of a circle."],
  halfWidth: ["halfWidth: 1", "Of a box."],
  halfHeight: ["halfHeight: 0.5", "Of a box."],
  offset: ["offset: [0, 1]", "From the body's place."],
  density: ["density: 1", "Mass is density times area."],
  friction: ["friction: 0.6", ""],
  restitution: ["restitution: 0.5", "How much it bounces, 0 to 1."],
  surfaceSpeed: ["surfaceSpeed: 2", "A conveyor belt."],
  sensor: ["sensor: true", "Notes what is there, stops nothing."],
};

const SCENE: Record<keyof Scene, Entry> = {
  world: ["return { world }", "What runs. All else may be left out."],
  view: ["view: { x: 0, y: 5, height: 12 }", "What to look at first."],
  update: [
    "update({ held, step }) { … }",
    "Before each step. Its own variables belong into state.",
  ],
  paint: [
    "paint: () => ({ marks, figures, message })",
    "After each step: what to draw besides the bodies.",
  ],
  state: [
    "state: { score: 0 }",
    "Plain data that update changes: going back in time takes it along.",
  ],
  keys: [
    'keys: { left: "walk", fire: "shoot" }',
    "Keys and what they do: they come as held.left…; a phone gets buttons.",
  ],
  pointer: ["pointer: true", "The pointer comes to update, and drags nothing."],
  hidden: ["hidden: [ball.index]", "Bodies that paint draws instead."],
  spawn: ["spawn: [0, 8]", "Where new bodies drop by keyboard."],
  show: ['show: ["contacts"]', "Overlays that are on from the start."],
  notes: ['notes: ["…"]', "What the visitor should be told."],
  sums: ["sums: 1", "Pairs shown with their Minkowski sum."],
  restored: ["restored() { … }", "After state went back in time."],
  close: ["close() { … }", "Frees what createMover made."],
};

const INPUT: Record<keyof Input, Entry> = {
  held: ["if (held.left) …", "left, right, up, down, fire, restart."],
  step: ["step % 60 === 0", "Steps since the beginning."],
  pointer: ["pointer?.down", "x, y and down; null until there is one."],
};

const PAINT: Record<keyof Paint, Entry> = {
  marks: ['marks: [{ kind: "circle", x, y, radius, ink: "gold" }]', "Drawn over the bodies."],
  figures: ['figures: [{ label: "Score", value: "3" }]', "At the top."],
  message: ['message: "You won."', "A line; said to screen readers."],
  follow: ["follow: [x, y]", "The view goes after it."],
};

const MARKS: Record<Mark["kind"], Entry> = {
  line: ['{ kind: "line", points: [[0, 0], [1, 2]], ink: "soft" }', "width, dashed"],
  circle: ['{ kind: "circle", x, y, radius: 1, ink: "good" }', "opacity, filled"],
  box: [
    '{ kind: "box", x, y, halfWidth: 1, halfHeight: 2, ink: "bad" }',
    "angle, round, opacity, filled",
  ],
  figure: [
    '{ kind: "figure", x, y, halfWidth: 1, halfHeight: 2, facing: 1, ink: "player" }',
    "A box with eyes.",
  ],
  text: ['{ kind: "text", x, y, text: "Hello", ink: "ink" }', "size"],
};

/** `completes` says where a name is offered: as it is, or only after a dot. */
export const GROUPS: readonly {
  title: string;
  entries: Readonly<Record<string, Entry>>;
  completes: "plain" | "member";
}[] = [
  { title: "The function is given", entries: SETTING, completes: "plain" },
  { title: "Options of createWorld", entries: WORLD_OPTIONS, completes: "plain" },
  { title: "A world", entries: WORLD, completes: "member" },
  { title: "Options of createBody", entries: BODY, completes: "plain" },
  { title: "Options of shapes", entries: SHAPE, completes: "plain" },
  { title: "The function returns", entries: SCENE, completes: "plain" },
  { title: "What update is given", entries: INPUT, completes: "plain" },
  { title: "What paint returns", entries: PAINT, completes: "plain" },
  { title: "Marks", entries: MARKS, completes: "plain" },
];
