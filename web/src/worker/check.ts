/**
 * Checks what a scene's function and its `paint` return before the page uses it. A visitor can edit
 * the text of a scene and return anything; a wrong value throws a SceneError, whose message says
 * which field is wrong and what it should look like.
 */
import type { Control } from "../scene/controls";
import {
  KEY_NAMES,
  type KeyName,
  type Mark,
  type Paint,
  type Scene,
  SCENE_PANELS,
} from "../scene/scene";
import { SceneError } from "./trouble";

/**
 * Optional fields of a Scene that are functions, fields that are arrays, and the kinds of controls.
 */
const FUNCTIONS = ["restored", "update", "stepped", "pointed", "paint", "close"] as const;
const LISTS = ["notes", "show", "hidden", "controls"] as const;
const CONTROLS: readonly Control["kind"][] = ["choice", "check", "slider", "matrix"];

/** The fields of each kind of mark that must be finite numbers. */
const NUMBERS: Record<Mark["kind"], readonly string[]> = {
  line: [],
  circle: ["x", "y", "radius"],
  box: ["x", "y", "halfWidth", "halfHeight"],
  figure: ["x", "y", "halfWidth", "halfHeight", "facing"],
  text: ["x", "y"],
};

/** Throws a SceneError if a field of the scene is wrong. */
export function checkScene(scene: Scene): void {
  const { view, spawn, keys = [], state, panel } = scene;
  for (const name of FUNCTIONS)
    if (scene[name] !== undefined && typeof scene[name] !== "function")
      wrong(`A scene's ${name} is a function: ${name}() { … }`);
  for (const name of LISTS)
    if (scene[name] !== undefined && !Array.isArray(scene[name]))
      wrong(`A scene's ${name} is a list: ${name}: […]`);
  for (const one of [view, view?.tall]) {
    const { x, y, height, width = 1 } = one ?? { x: 0, y: 0, height: 1 };
    if (![x, y, height, width].every(Number.isFinite) || height <= 0 || width <= 0)
      wrong("A scene's view has finite numbers: view: { x: 0, y: 5, height: 20 }");
  }
  if (spawn !== undefined && !isPlace(spawn)) wrong("A scene's spawn is a place: spawn: [0, 10]");
  if (panel !== undefined && !SCENE_PANELS.includes(panel))
    wrong(`A scene's panel is one of ${SCENE_PANELS.join(", ")}.`);
  if (typeof keys !== "object" || !Object.values(keys).every((word) => typeof word === "string"))
    wrong('A scene\'s keys is a list, or tells what each does: keys: { left: "walk" }');
  for (const key of (Array.isArray(keys) ? keys : Object.keys(keys)) as KeyName[])
    if (!KEY_NAMES.includes(key))
      wrong(`There is no key “${String(key)}” for scenes; there are ${KEY_NAMES.join(", ")}.`);
  if (state !== undefined && (typeof state !== "object" || state === null))
    wrong("A scene's state is an object: state: { score: 0 }");
  for (const control of scene.controls ?? []) {
    if (!CONTROLS.includes(control?.kind))
      wrong(`The kind of a control is one of ${CONTROLS.join(", ")}.`);
    if (!state || !Object.hasOwn(state, control.name))
      wrong(`A control sets what state has: state: { ${control.name}: … }`);
  }
}

/** Throws a SceneError if a field of what `paint` returned is wrong. */
export function checkPaint(paint: Paint): void {
  const { follow, marks = [], figures = [], message = "", buttons = {}, readings = {} } = paint;
  if (follow !== undefined && !isPlace(follow)) wrong("paint: follow is a place: follow: [x, y]");
  if (!Array.isArray(marks)) wrong("paint: marks is a list of marks.");
  if (!Array.isArray(figures)) wrong("paint: figures is a list of { label, value }.");
  for (const mark of marks) checkMark(mark);
  for (const figure of figures)
    if (typeof figure?.label !== "string" || typeof figure.value !== "string")
      wrong("paint: a figure has two texts: { label: \"Score\", value: \"3\" }");
  if (typeof message !== "string") wrong("paint: message is a text.");
  for (const rows of Object.values(readings))
    if (!Array.isArray(rows) || !rows.every((row) => Array.isArray(row) && row.length === 2))
      wrong('paint: readings has rows of two texts: readings: { wind: [["Speed", "3 m/s"]] }');
  for (const [name, word] of Object.entries(buttons))
    if (!KEY_NAMES.includes(name as KeyName) || typeof word !== "string")
      wrong('paint: buttons has a word for each key: buttons: { fire: "Drive" }');
}

function checkMark(mark: Mark): void {
  const numbers = NUMBERS[mark?.kind];
  if (!numbers)
    wrong(`paint: the kind of a mark is one of ${Object.keys(NUMBERS).join(", ")}.`);
  for (const name of numbers)
    if (!Number.isFinite((mark as unknown as Record<string, unknown>)[name]))
      wrong(`paint: a mark of kind ${mark.kind} has a finite number ${name}.`);
  if (mark.kind === "text" && typeof mark.text !== "string")
    wrong("paint: a mark of kind text has a text.");
  if (mark.kind === "line" && !(Array.isArray(mark.points) && mark.points.every(isPlace)))
    wrong("paint: a line's points are places: points: [[0, 0], [1, 1]]");
}

function isPlace(value: unknown): boolean {
  return Array.isArray(value) && value.length === 2 && value.every(Number.isFinite);
}

function wrong(message: string): never {
  throw new SceneError({ message });
}
