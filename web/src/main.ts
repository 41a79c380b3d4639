/** The page: loads the engine, runs a scene, and connects controls, pointers and drawing. */
import { type Broadphase, type Detection, load, type Quality } from "thud";
import { LevelError } from "thud/level";
import wasmUrl from "../generated/thud-demo.wasm?url";
import { type Built, Catalogue, type Entry } from "./catalogue";
import { Hud } from "./hud";
import { listen, type Tool } from "./input";
import { listenToPad } from "./pad";
import type { OverlayName } from "./render/overlay";
import { DYNAMIC, ROW } from "./render/shapes";
import { Simulation } from "./simulation";
import { byId, type ThemeChoice, Ui } from "./ui";
import { readState, writeState } from "./url";
import { View } from "./view";

const FIRST_SCENE = "pyramid";
const THEME_KEY = "thud-theme";
/** A crater's radius that can be seen, however far away the view is. */
const CRATER_PIXELS = 16;
/** Metres of the world, in length scales, that are seen around a character. */
const CHARACTER_VIEW = { height: 20, width: 13 };
/** How fast the view follows it, in 1/s. */
const FOLLOW_RATE = 6;

const systemIsLight = matchMedia("(prefers-color-scheme: light)");
const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

const state = {
  quality: "default" as Quality,
  detection: "continuous" as Detection,
  broadphase: "grid" as Broadphase,
  speed: 1,
  // Whoever asked for less motion starts it deliberately.
  paused: reducedMotion.matches,
  tool: "hand" as Tool,
  ...readState(location.search),
};

const pad = byId("pad");
const keys = listenToPad(pad);

let simulation: Simulation | null = null;
let catalogue: Catalogue;
let view: View;
let hud: Hud;
/** The overlays that are shown because the scene is about them, and go with it. */
let lent: readonly OverlayName[] = [];
/** Builds the running scene anew. */
let rebuild: () => Promise<Built> | Built;

const ui = new Ui({
  choose: (entry) => void run(() => catalogue.build(entry, state)),
  openFile: (file) => void openFile(file),
  togglePause: () => setPaused(!state.paused),
  step: () => {
    setPaused(true);
    guard(() => simulation?.step());
  },
  reset: () => void run(rebuild, true),
  fit: lookHome,
  setTool: (tool) => {
    state.tool = tool;
    ui.showTool(tool);
  },
  setSpeed: (speed) => {
    state.speed = speed;
    if (simulation) simulation.speed = speed;
    keepState();
  },
  setQuality: (quality) => {
    state.quality = quality;
    guard(() => simulation?.setQuality(quality));
    keepState();
  },
  setDetection: (detection) => {
    state.detection = detection;
    if (simulation) void run(rebuild, true);
  },
  setBroadphase: (broadphase) => {
    state.broadphase = broadphase;
    if (simulation) void run(rebuild, true);
  },
  setOverlay: (name, on) => {
    lent = lent.filter((other) => other !== name);
    show(name, on);
  },
  setTheme: (theme) => {
    localStorage.setItem(THEME_KEY, theme);
    applyTheme();
  },
  pan: (dx, dy) => view.camera.pan(dx, dy),
  zoom: (factor) => view.camera.zoom(factor),
});

void start();

async function start(): Promise<void> {
  if (typeof WebAssembly !== "object") {
    ui.fail(
      "WebAssembly is missing",
      "thud runs as WebAssembly, which this browser lacks or has switched off. Any current " +
        "browser has it; some switch it off in a lockdown or high-security mode.",
    );
    return;
  }
  try {
    view = new View({
      backdrop: byId<HTMLCanvasElement>("backdrop"),
      bodies: byId<HTMLCanvasElement>("bodies"),
      overlay: byId<HTMLCanvasElement>("overlay"),
    });
    hud = new Hud(byId("hud"), byId("timings"));
    catalogue = new Catalogue(await load(new URL(wasmUrl, location.href)));
  } catch (error) {
    ui.fail(
      "The engine cannot be loaded",
      "The page came without its WebAssembly file, or this browser cannot run it. Loading the " +
        "page again may help.",
      [messageOf(error)],
      () => location.reload(),
    );
    return;
  }
  applyTheme();
  systemIsLight.addEventListener("change", applyTheme);
  window.addEventListener("resize", layOut);
  layOut();
  ui.fillScenes(catalogue.entries);
  ui.showTool(state.tool);
  ui.showChoice("speed", String(state.speed));
  ui.showChoice("quality", state.quality);
  ui.showChoice("detection", state.detection);
  ui.showChoice("broadphase", state.broadphase);
  ui.showPaused(state.paused);
  listenToPointers();
  requestAnimationFrame(frame);
  await runFirst();
}

async function runFirst(): Promise<void> {
  const first = catalogue.find("scene", FIRST_SCENE) ?? catalogue.entries[0];
  const runDefault = () => run(() => catalogue.build(first, state));
  if (!state.kind || !state.name) return runDefault();
  const entry = catalogue.find(state.kind, state.name);
  if (entry) return run(() => catalogue.build(entry, state));
  const text = `There is no ${state.kind} called “${state.name}” here.`;
  ui.fail("Not found", text, [], () => void runDefault());
}

/** Replaces the running scene; if that fails, the one that runs goes on. */
async function run(build: () => Promise<Built> | Built, keepView = false): Promise<void> {
  let next: Simulation;
  try {
    next = new Simulation(await build(), keys);
  } catch (error) {
    const problems = error instanceof LevelError ? error.problems.map(({ text }) => text) : [];
    const text = problems.length > 0 ? "The file cannot be used:" : messageOf(error);
    ui.fail("This scene cannot be run", text, problems, () => {
      if (!simulation) void run(() => catalogue.build(catalogue.entries[0], state));
    });
    return;
  }
  simulation?.close();
  simulation = next;
  rebuild = build;
  next.paused = state.paused;
  next.speed = state.speed;
  hud.reset();
  pad.hidden = !next.character;
  const { entry, problems } = next.built;
  if (keepView) ui.say(`${entry.title}, from the beginning`);
  else {
    showWhole(next);
    lend(next.built.show);
    ui.showScene(entry);
    if (problems.length > 0) {
      const more = problems.length > 1 ? ` (and ${problems.length - 1} more)` : "";
      ui.notice(`Left out: ${problems[0].text}${more}`, 12);
    }
  }
  keepState(entry);
}

function show(name: OverlayName, on: boolean): void {
  if (on) view.shown.add(name);
  else view.shown.delete(name);
  byId("timings").hidden = !view.shown.has("timings");
}

/** Shows what a scene is about; what the one before had brought goes. */
function lend(overlays: readonly OverlayName[]): void {
  for (const name of lent) show(name, false);
  lent = overlays.filter((name) => !view.shown.has(name));
  for (const name of lent) show(name, true);
  ui.showOverlays(view.shown);
}

async function openFile(file: File): Promise<void> {
  const name = file.name.replace(/\.[^.]*$/, "");
  const text = await file.text();
  await run(() => catalogue.buildText(name, text, state));
}

/** The scene's own view, and as wide as what moves in it, within reason. */
function showWhole({ built, shapes, world, character }: Simulation): void {
  if (character) {
    const { height, width } = CHARACTER_VIEW;
    const unit = built.lengthScale;
    view.camera.setHome(...character.place(1), height * unit, width * unit);
    return;
  }
  const [x, y] = built.camera;
  const poses = world.poses(1, x, y);
  let reach = 0;
  for (let i = 0; i < shapes.count; i++) {
    const [slot, , bodyKind] = shapes.rows.subarray(i * ROW, i * ROW + 3);
    const distance = Math.abs(poses[4 * slot]);
    if (bodyKind === DYNAMIC && distance <= built.cameraHeight) reach = Math.max(reach, distance);
  }
  view.camera.setHome(x, y, built.cameraHeight, Math.min(2.2 * reach, 2 * built.cameraHeight));
}

function lookHome(): void {
  view.camera.goHome();
  const character = simulation?.character;
  if (character) view.camera.follow(character.place(1), 1);
}

/** The view closes in on a character while it moves, and is the visitor's while it stands. */
function followCharacter({ character, alpha, paused }: Simulation, seconds: number): void {
  const dragged = byId("overlay").dataset.mode;
  if (!character?.moves || paused || dragged === "pan" || dragged === "pinch") return;
  view.camera.follow(character.place(alpha), 1 - Math.exp(-FOLLOW_RATE * seconds));
}

function setPaused(paused: boolean): void {
  state.paused = paused;
  if (simulation) simulation.paused = paused;
  ui.showPaused(paused);
  ui.say(paused ? "Paused" : "Running");
  keepState();
}

/** A level of the visitor's own has no address. */
function keepState(entry: Entry | undefined = simulation?.built.entry): void {
  if (!entry || !catalogue.find(entry.kind, entry.name)) return;
  writeState({ ...state, kind: entry.kind, name: entry.name });
}

function listenToPointers(): void {
  listen(byId("overlay"), view.camera, {
    tool: () => state.tool,
    grab: (x, y, reach) => simulation?.grab(x, y, reach) ?? false,
    moveGrab: (x, y) => simulation?.moveGrab(x, y),
    release: () => simulation?.release(),
    apply: (tool, x, y) =>
      guard(() => {
        if (tool !== "dig") simulation?.spawn(tool, x, y);
        else if (!simulation?.dig(x, y, CRATER_PIXELS / view.camera.scale))
          ui.notice("There is no ground to dig here: try the scene Digging.");
      }),
  });
}

let lastTime = 0;
function frame(time: number): void {
  requestAnimationFrame(frame);
  const seconds = lastTime > 0 ? (time - lastTime) / 1000 : 0;
  lastTime = time;
  if (!simulation) return;
  const running = simulation;
  guard(() => {
    running.frame(seconds);
    followCharacter(running, seconds);
    view.draw(running);
    hud.frame(seconds, running.world.stats(), running.world.error());
  });
}

/** What the engine refuses while running is said once, and the scene stands still. */
function guard(act: () => void): void {
  try {
    act();
  } catch (error) {
    console.error(error);
    setPaused(true);
    ui.notice(messageOf(error), 30);
  }
}

function layOut(): void {
  const top = byId("top").getBoundingClientRect().bottom;
  const bottom = innerHeight - byId("controls").getBoundingClientRect().top;
  view.camera.insets = { top: top + 8, right: 16, bottom: bottom + 8, left: 16 };
  view.resize();
  lookHome();
}

function applyTheme(): void {
  const stored = localStorage.getItem(THEME_KEY);
  const choice: ThemeChoice = stored === "dark" || stored === "light" ? stored : "system";
  const dark = choice === "system" ? !systemIsLight.matches : choice === "dark";
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  ui.showChoice("theme", choice);
  view.setTheme(dark);
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
