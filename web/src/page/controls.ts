/** The buttons under the scene and the page's keyboard shortcuts: what each of them does. */
import { DETECTION_CHOICES, SPEEDS } from "./url";
import { BROADPHASES, QUALITIES } from "thud";
import type { App } from "./app";
import { findScene } from "../scene/registry";
import { openDialog } from "./dialogs";
import type { Dock } from "./dock";
import { byId } from "./dom";
import { type Key, key, listenToKeys } from "./input/keys";
import { notice, say } from "./messages";
import { TOOLS, type Tool } from "./input/pointers";
import type { Stage } from "./stage";
import { OVERLAYS, type OverlayName } from "../scene/overlays";

/** CSS pixels that an arrow key moves the view. Chosen. */
const PAN = 60;
/** The key of each overlay. Most are those of the native viewer (demo/play/panel/overlays.c). */
const OVERLAY_KEYS: Readonly<Record<OverlayName, readonly [cap: string, what: string]>> = {
  contacts: ["1", "contact points"],
  normals: ["2", "contact normals"],
  bounds: ["3", "bounds"],
  cells: ["4", "grid cells"],
  islands: ["5", "islands"],
  sleeping: ["6", "who sleeps"],
  stages: ["7", "pairs by stage"],
  axes: ["8", "sweep intervals"],
  pairs: ["9", "pairs"],
  motions: ["M", "swept volumes"],
  colours: ["J", "solver colours"],
  sums: ["Y", "Minkowski sums"],
  joints: [";", "joints: forces, and what is open"],
  impulses: ["U", "depths and impulses"],
};

/** Connects buttons and keys with the app, the stage and the dock. */
export function addControls(app: App, stage: Stage, dock: Dock): void {
  const togglePause = () => {
    app.setPaused(!app.state.paused);
    say(app.state.paused ? "Paused" : "Running");
  };
  const setTool = (tool: Tool) => {
    stage.setTool(tool);
    for (const button of document.querySelectorAll<HTMLElement>("button[data-tool]"))
      button.setAttribute("aria-pressed", String(button.dataset.tool === tool));
  };
  byId("pause").addEventListener("click", togglePause);
  byId("step").addEventListener("click", () => app.stepOnce());
  byId("restart").addEventListener("click", () => void app.restart());
  byId("fit").addEventListener("click", () => stage.home());
  addFullScreen(byId("full"));
  for (const tool of TOOLS)
    document
      .querySelector(`button[data-tool=${tool}]`)!
      .addEventListener("click", () => setTool(tool));
  setTool("hand");
  // Where the row of buttons scrolls, browsers leave a button that gets the focus half hidden.
  byId("controls").addEventListener("focusin", ({ target }) =>
    (target as HTMLElement).scrollIntoView({ block: "nearest", inline: "nearest" }),
  );
  app.listen({
    state: ({ paused }) => byId("pause").setAttribute("aria-pressed", String(paused)),
    run() {
      const isGame = findScene(app.state.scene)?.group === "Games";
      byId("controls").toggleAttribute("data-game", isGame);
      if (isGame) setTool("hand");
    },
  });
  listenToKeys(keysOf(app, stage, dock, togglePause, setTool));
}

/** The button for full screen; hidden where the browser does not allow it. */
function addFullScreen(button: HTMLElement): void {
  button.hidden = !document.fullscreenEnabled;
  button.addEventListener("click", () => {
    const done = document.fullscreenElement
      ? document.exitFullscreen()
      : document.documentElement.requestFullscreen();
    done.catch(() => notice("The browser does not let this page fill the screen."));
  });
  document.addEventListener("fullscreenchange", () =>
    button.setAttribute("aria-pressed", String(Boolean(document.fullscreenElement))),
  );
}

/** The value `by` places further in a list; beyond its ends the first or last one. */
function near<T>(values: readonly T[], value: T, by: number): T {
  const at = values.indexOf(value) + by;
  return values[Math.min(values.length - 1, Math.max(0, at))];
}

/** The value after this one in a list; after the last comes the first. */
function next<T>(values: readonly T[], value: T): T {
  return values[(values.indexOf(value) + 1) % values.length];
}

/** All shortcuts, in the order in which the help lists them. */
function keysOf(
  app: App,
  stage: Stage,
  dock: Dock,
  togglePause: () => void,
  setTool: (tool: Tool) => void,
): Key[] {
  const { state } = app;
  const { choices } = state;
  const speed = (by: number) => () => {
    app.setSpeed(near(SPEEDS, state.speed as (typeof SPEEDS)[number], by));
    notice(`Speed ${state.speed}×`, 2);
  };
  const quality = (by: number) => () => {
    app.choose({ quality: near(QUALITIES, choices.quality, by) });
    notice(`Quality ${choices.quality}`, 2);
  };
  const overlay = (name: (typeof OVERLAYS)[number]) => () => {
    const on = !stage.view.shown.has(name);
    stage.setOverlay(name, on);
    notice(`${on ? "Shows" : "Hides"} ${OVERLAY_KEYS[name][1]}`, 2);
  };
  const back = (steps: number) => () => {
    app.setPaused(true);
    const { newest } = app.player;
    void app.seek(Math.max(0, newest + steps)).catch(() => {});
  };
  return [
    key("Space P", [" ", "p"], "Pause, or run on", togglePause),
    key(".", ["."], "Single step", () => app.stepOnce()),
    key("Z", ["z"], "One step back", back(-1)),
    key("R", ["r"], "Restart the scene", () => void app.restart()),
    key("V", ["v"], "Drag bodies", () => setTool("hand")),
    key("C", ["c"], "Add circles", () => setTool("circle")),
    key("B", ["b"], "Add boxes", () => setTool("box")),
    key("N", ["n"], "Explode", () => setTool("blast")),
    key("G", ["g"], "Dig the ground", () => setTool("dig")),
    key("Enter", ["enter"], "Use the tool in the middle of the view", () => stage.actAtCrosshair()),
    key("[", ["["], "Slower", speed(-1)),
    key("]", ["]"], "Faster", speed(1)),
    key(",", [","], "Lower quality", quality(-1)),
    key("/", ["/"], "Higher quality", quality(1)),
    key("E", ["e"], "Next way of detection", () => {
      app.choose({ detection: next(DETECTION_CHOICES, choices.detection) });
      notice(`Detection ${choices.detection}`, 2);
    }),
    key("F", ["f"], "Next broadphase", () => {
      app.choose({ broadphase: next(BROADPHASES, choices.broadphase) });
      notice(`Broadphase ${choices.broadphase}`, 2);
    }),
    key("←", ["arrowleft"], "Move the view left", () => stage.pan(PAN, 0)),
    key("→", ["arrowright"], "Move the view right", () => stage.pan(-PAN, 0)),
    key("↑", ["arrowup"], "Move the view up", () => stage.pan(0, PAN)),
    key("↓", ["arrowdown"], "Move the view down", () => stage.pan(0, -PAN)),
    key("+", ["+", "="], "Zoom in", () => stage.zoom(1.25)),
    key("−", ["-"], "Zoom out", () => stage.zoom(0.8)),
    key("0", ["0"], "Show the whole scene", () => stage.home()),
    ...OVERLAYS.map((name) => {
      const [cap, what] = OVERLAY_KEYS[name];
      return key(cap, [cap.toLowerCase()], `Show ${what}`, overlay(name));
    }),
    key("X", ["x"], "Versus: thud and Box2D", () => dock.toggle("versus")),
    key("T", ["t"], "Trade: speed against accuracy", () => dock.toggle("trade")),
    key("I", ["i"], "Inside: what the engine sees", () => dock.toggle("inside")),
    key("Q", ["q"], "Inspect the body at the crosshair", () => {
      void dock.show("inside", false).then(() => stage.pickAtCrosshair());
    }),
    key("K", ["k"], "Code: the running scene", () => dock.toggle("code")),
    key("O", ["o"], "Options", () => dock.toggle("options")),
    key("L", ["l"], "Scenes, levels and games", () => openDialog("scenes")),
    key("H ?", ["h", "?"], "This list", () => openDialog("help")),
  ];
}
