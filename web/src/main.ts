/** The page: puts its parts together and starts the first scene. */
import { createRenderer } from "./draw/bodies";
import { App } from "./page/app";
import { addControls } from "./page/controls";
import { addDialogs } from "./page/dialogs";
import { Dock } from "./page/dock";
import { byId, make } from "./page/dom";
import { readDraft } from "./page/drafts";
import { addHint } from "./page/hint";
import { Hud } from "./page/hud";
import { fail, notice, say, type WayOn } from "./page/messages";
import type { Brought } from "./page/own-level";
import { Pad } from "./page/input/pad";
import { Stage } from "./page/stage";
import { applyTheme, onPrint, onTheme } from "./page/theme";
import { Timeline } from "./page/timeline";
import { readState, type State } from "./page/url";
import { panels } from "./panels/panels";
import { findScene, FIRST_SCENE } from "./scene/registry";
import { messageOf } from "./shared/error";
import { chooseWasm } from "./wasm/choose";
import type { RunningScene } from "./worker/protocol";

/** The scene that runs a level which the visitor has opened from a file. */
const OWN_LEVEL = "own_level";
/** The scene name of a recording which the visitor has opened from a file. */
const RECORDING = "recording";
/** The panel that shows the scene's code and its errors. */
const CODE_PANEL = "code";
/** Where a scene's controls are. */
const VALUES_PANEL = "values";
/**
 * The panel in which a game is played with others over a network. Its button is shown for games
 * that can be.
 */
const MATCH_PANEL = "match";
/**
 * A scene whose `Player.lag` (the share of real time by which it falls behind) is above this is
 * reported as slow.
 */
const MUCH_LAG = 0.2;
/**
 * When a visitor's code does not answer, the visitor may end it or wait. After this many
 * milliseconds the page ends it.
 */
const LONGEST_STUCK = 10_000;
/**
 * If the address opens a panel, the first scene waits for it to load, but at most for this many
 * milliseconds.
 */
const LONGEST_WAIT = 5000;

void start();

async function start(): Promise<void> {
  applyTheme();
  if (typeof WebAssembly !== "object" || typeof Worker !== "function") {
    fail(
      "WebAssembly is missing",
      "thud runs as WebAssembly in a worker, which this browser lacks or has switched off. Any " +
        "current browser has it; some switch it off in a lockdown or high-security mode.",
    );
    return;
  }
  let stage: Stage;
  const app = new App(() => stage.look);
  const wasm = chooseWasm();
  const loaded = app.load(wasm);
  loaded.catch(() => {}); // a failure is reported where `loaded` is awaited, below; this keeps the browser from reporting it if that line is never reached
  try {
    stage = new Stage(await createRenderer(byId<HTMLCanvasElement>("bodies")));
  } catch (error) {
    fail("Nothing can be drawn", messageOf(error), [], reload);
    return;
  }
  stage.attach(app);
  // The figures and the time slider, which take up space, are added before the engine is loaded, so
  // that the scene need not move when it appears.
  const hud = new Hud();
  new Timeline(app);
  layOut(app, stage);
  try {
    await loaded;
  } catch (error) {
    fail(
      "The engine cannot be loaded",
      "The page came without its WebAssembly file, or this browser cannot run it. Loading the " +
        "page again may help.",
      [messageOf(error)],
      reload,
    );
    return;
  }
  if (!wasm.simd)
    notice("This browser has no WebAssembly SIMD: everything works, only slower.", 12);
  await assemble(app, stage, hud);
}

/**
 * Loads what the first picture does not need: the rest of the engine, the gallery, and the service
 * worker.
 */
function afterFirstPicture(app: App, loadGallery: () => void): void {
  performance.mark("first picture");
  app.client
    .ask("complete", {})
    .catch((error) => fail("A part of the engine is missing", messageOf(error), [], reload))
    .finally(loadGallery);
  // If this fails, the page works all the same, but only with a network.
  import("./offline/register").then(({ keepOffline }) => keepOffline(offerUpdate), () => {});
}

function offerUpdate(update: () => void): void {
  const button = make("button", {}, "Reload");
  button.addEventListener("click", update);
  notice("A new version of this page is ready. ", 60);
  byId("notice").append(button);
}

const reload = { label: "Load the page again", go: () => location.reload() };

async function assemble(app: App, stage: Stage, hud: Hud): Promise<void> {
  const pad = new Pad((held) => app.do({ kind: "keys", held }));
  const change = () => layOut(app, stage);
  const dock = new Dock(app, panels(stage), change);
  const openFiles = async (brought: Brought[]) => {
    const { openBrought } = await import("./page/brought");
    await openBrought(app, brought);
  };
  addDialogs();
  let gallery: Promise<void> | null = null;
  const loadGallery = () => {
    gallery ??= import("./page/gallery").then(
      ({ ABOUTS, addGallery, describeScene, Score, ...words }) => {
        addGallery(app, dock, (brought) => void openFiles(brought));
        score = new Score();
        // The scene may be paused, so that no further frame comes: the figures of the shown one are
        // shown now.
        if (score.show(app.player.shown?.frame.paint ?? null)) change();
        describeScene(app);
        how = words;
        app.abouts = ABOUTS;
        app.chosen();
      },
      (error) => {
        gallery = null;
        notice(`The list of scenes cannot be loaded: ${messageOf(error)}`);
      },
    );
  };
  byId("scenes").addEventListener("open", loadGallery);
  addControls(app, stage, dock);
  listenToScenes(app, { dock, hud, hinted: addHint(app), change });
  app.listen({
    run({ keys }) {
      pad.show(keys);
      change();
    },
    frame({ paint }) {
      if (pad.name(paint?.buttons)) change();
    },
  });

  onTheme((dark) => stage.view.setTheme(dark));
  applyTheme();
  onPrint(() => stage.draw(0));
  window.addEventListener("resize", change);
  // The visitor followed a link that differs only in the part after the #, such as other code:
  // browsers do not load the page again for that, so it is done here.
  window.addEventListener("hashchange", () => history.state ?? location.reload());
  // The visitor went back or forward in the browser's history, to another scene.
  window.addEventListener("popstate", ({ state }) => {
    if (state) void readAddress(app).then((address) => address && runFirst(app, address));
  });

  const state = await readAddress(app);
  let lastTime = 0;
  let pictured = false;
  const draw = (time: number) => {
    requestAnimationFrame(draw);
    const seconds = lastTime > 0 ? (time - lastTime) / 1000 : 0;
    lastTime = time;
    app.player.advance(seconds);
    if (app.player.lag > MUCH_LAG) tellSlow(app);
    app.requestFrame();
    stage.draw(seconds);
    const shown = app.player.shown;
    if (!shown) return;
    hud.show(shown.frame, seconds);
    if (!pictured) afterFirstPicture(app, loadGallery);
    pictured = true;
  };
  requestAnimationFrame(draw);
  if (state?.panel) waitForPanel(app);
  if (state) await runFirst(app, state);
  const panel = app.offeredCode === null ? state?.panel : CODE_PANEL;
  if (panel) await dock.show(panel, false);
  app.player.waiting = false;
}

/** The functions that describe a game's keys. They are loaded with the gallery's module. */
let how: Pick<typeof import("./page/how"), "howToPlay" | "isTouch"> | null = null;

/** Shows the figures and the message of a game. It is loaded with the gallery's module. */
let score: InstanceType<typeof import("./page/score").Score> | null = null;

let slow: Promise<void> | null = null;

/**
 * Shows a notice that an error has stopped the scene, with a button that saves a recording of the
 * steps before it.
 */
function tellStopped(app: App, message: string): void {
  notice(`The scene stopped: ${message} `, 30);
  if (app.state.match || app.state.recording?.fork === null) return;
  const button = make("button", { id: "save-stopped" }, "Save a recording of it");
  button.addEventListener("click", () => {
    void import("./page/recording").then(
      ({ saveRecording }) => saveRecording(app),
      (error) => notice(`A part of the page cannot be loaded: ${messageOf(error)}`),
    );
  });
  byId("notice").append(button);
}

/** Loads the report on slow scenes when it is first needed, which is never for most scenes. */
function tellSlow(app: App): void {
  slow ??= import("./page/slow").then(({ watch }) => watch(app));
}

/**
 * Lets the clock wait before the first step, so that a panel that compares or records gets all
 * steps. The clock starts after LONGEST_WAIT at the latest.
 */
function waitForPanel({ player }: App): void {
  player.waiting = true;
  setTimeout(() => (player.waiting = false), LONGEST_WAIT);
}

/** The number of addresses that were begun to be read; the result of an earlier one is dropped. */
let addressesRead = 0;

/**
 * Reads the state from the page's address. Null if the visitor has opened another address
 * meanwhile.
 */
async function readAddress(app: App): Promise<Partial<State> | null> {
  const number = ++addressesRead;
  const kept = history.state as Partial<State> | null;
  app.leaveAddress();
  const state = await readState(new URL(location.href));
  if (number !== addressesRead) return null;
  state.level ??= kept?.level;
  app.begin(state);
  return state;
}

async function runFirst(app: App, state: Partial<State>): Promise<void> {
  const { scene = FIRST_SCENE, size, seed, code, camera, claim, level, invite } = state;
  const own = scene === OWN_LEVEL;
  if (own ? !level : !findScene(scene)) {
    if (scene === RECORDING) {
      const text = "No link holds a recording. Whoever has its file can open it here, under Scenes.";
      fail("The recording is not in this link", text, [], toFirst(app));
      return;
    }
    const text = own
      ? "It was too large for a link, or the link is damaged. Whoever has its file can open it " +
        "here, under Scenes."
      : `There is no scene called “${scene}” here.`;
    fail(own ? "The level is not in this link" : "Not found", text, [], toFirst(app));
    return;
  }
  // Code from a link may be a stranger's, unless it is the draft that was written in this tab. It
  // is shown, and runs only when the visitor says so.
  const more = { size, seed, camera, claim, level, invite };
  const draft = code && readDraft(scene) === code ? code : null;
  if (!draft || !(await app.open(scene, { ...more, code: draft }))) await app.open(scene, more);
  if (code && !draft) app.offerCode(code);
  tellStill(app);
  if (code === null)
    notice("The code in this link is damaged, so the page’s own scene runs.", 20);
}

/**
 * If the scene is paused because the visitor's system asks for reduced motion, shows a notice that
 * says how to run it.
 */
function tellStill(app: App): void {
  if (!app.waitsForMotion) return;
  notice("You asked your device for less motion, so the scene waits: press Play ▶ to run it.", 3600);
  const stop = app.listen({
    state({ paused }) {
      if (paused) return;
      stop();
      notice("");
    },
  });
}

function toFirst(app: App): WayOn {
  return { label: "Go to the first scene", go: () => void app.open(FIRST_SCENE) };
}

/**
 * Shows messages about the running scene: what to look at, how to play, what went wrong. `hinted`:
 * the hint of a first visit is shown; `change` lays the page out anew.
 */
function listenToScenes(
  app: App,
  parts: { dock: Dock; hud: Hud; hinted: boolean; change(): void },
): void {
  const { dock, hud, change } = parts;
  let { hinted } = parts;
  let announced = "";
  /**
   * Four states of the running scene: `untold`, its message has not been shown yet; `framed`, its
   * first frame has come; `speaks`, the scene shows a message of its own; `worded`, its on-screen
   * buttons have words.
   */
  let [untold, framed, speaks, worded] = [false, false, false, false];
  const tell = () => {
    if (!untold || !framed || !app.abouts || !how) return;
    untold = false;
    const { about } = app;
    const play = worded && how.isTouch() ? "" : how.howToPlay(app.scene!.keys);
    const text = `${speaks ? "" : about} ${play}`.trim();
    if ((speaks || (hinted && !play)) && about) say(about);
    // While the hint of a first visit is shown, the only message is how the game is played.
    if (text && (play || !hinted) && byId("notice").hidden) notice(text, play ? 15 : 7);
    hinted = false;
  };
  /** Hides the failure message of a scene that could not be run, or did not answer. */
  let takeBack = () => {};
  /** The module that lists the notes of a scene; loaded when a scene first has some. */
  let leftOut: Promise<typeof import("./page/left-out")> | undefined;
  app.listen({
    run(scene) {
      takeBack();
      hud.reset();
      score?.reset();
      document.querySelector("main")!.removeAttribute("aria-busy");
      const { title } = app;
      byId("scene-title").textContent = title;
      byId("scenes-button").setAttribute("aria-label", `Scenes and levels; now: ${title}`);
      document.title = `${title} · thud`;
      // The title alone does not tell two scenes apart: a visitor's code may have the same title
      // and other keys.
      const played = title + JSON.stringify(scene.keys);
      untold = announced !== played;
      framed = false;
      say(untold ? title : `${title}, from the beginning`);
      // A message about the scene before does not apply to this one.
      if (untold && announced !== "") {
        notice("");
        hinted = false;
      }
      announced = played;
      showPanel(dock, scene, untold, !app.state.match && (app.state.invite !== null || wasInRoom()));
      if (app.state.code !== null)
        void import("./page/memory").then(({ watchMemory }) => watchMemory(app));
      const { notes } = scene;
      if (notes.length > 0) {
        untold = false;
        leftOut ??= import("./page/left-out");
      }
      void leftOut?.then(({ showNotes }) => showNotes(notes));
    },
    frame({ paint }) {
      if (score?.show(paint)) change();
      framed = true;
      // If the scene shows a message of its own, the page does not repeat what to do.
      speaks = Boolean(paint?.message);
      worded = Boolean(paint?.buttons);
      tell();
    },
    state: tell,
    samples: (samples) => hud.add(samples),
    trouble(trouble, running) {
      if (trouble.tooLarge) {
        const coded = app.state.code !== null;
        takeBack = fail("The scene takes too much memory", trouble.message, [], {
          label: coded ? "Go back" : "Start another scene",
          go: () => void (coded ? app.endCode() : app.revive(FIRST_SCENE)),
        });
        return;
      }
      // The code panel shows errors of the visitor's own text at their line.
      if (app.state.code !== null) {
        void dock.show(CODE_PANEL, false);
        return;
      }
      const { message, details } = trouble;
      if (running) tellStopped(app, message);
      else
        takeBack = fail(
          `This ${app.state.recording ? "recording" : app.state.level ? "level" : "scene"} cannot be run`,
          message,
          details,
          // The scene that ran before goes on running, so that going back has nothing to do.
          app.scene ? { label: "Go back", go() {} } : toFirst(app),
        );
    },
    stuck() {
      if (app.state.code !== null) {
        takeBack = fail(
          "The code does not answer",
          "A step, or building the scene, takes longer than eight seconds or never ends: a loop " +
            "without an end? In ten seconds more it is ended. Your text is kept.",
          [],
          { label: "End it and go back", go: () => void app.endCode() },
        );
        // Code in an endless loop may allocate memory until the whole tab crashes.
        const end = setTimeout(() => {
          takeBack();
          void app.endCode();
          notice("The code did not answer, and was ended. Your text is kept.", 20);
        }, LONGEST_STUCK);
        const hide = takeBack;
        takeBack = () => {
          clearTimeout(end);
          hide();
        };
        return;
      }
      takeBack = fail(
        "The scene does not answer",
        "A step takes longer than eight seconds, or never ends. Wait on, or end it.",
        [],
        { label: "End it and start another scene", go: () => void app.revive(FIRST_SCENE) },
      );
    },
    answers: () => takeBack(),
  });
}

/**
 * Opens the panel that a new scene asks for. The button of the panel Values is shown for scenes
 * with controls only. `begins`: the scene is not the one before, started again. `comes`: the
 * visitor is invited to a match, or may return to one.
 */
function showPanel(
  dock: Dock,
  { controls, panel, shared }: RunningScene,
  begins: boolean,
  comes: boolean,
): void {
  const has = controls.length > 0;
  const show = (name: string, shown: boolean) => {
    document.querySelector<HTMLElement>(`button[data-panel=${name}]`)!.hidden = !shown;
    if (!shown && dock.open === name) dock.close();
  };
  show(VALUES_PANEL, has);
  show(MATCH_PANEL, shared);
  if (!begins) return;
  // On a phone the panel would cover the game's buttons.
  if (shared && (comes || matchMedia("(width >= 40em)").matches)) void dock.show(MATCH_PANEL, false);
  else if (panel) void dock.show(panel === "contacts" ? "inside" : panel, false);
  else if (has) void dock.show(VALUES_PANEL, false);
}

/** Whether this tab was in a match to which it may return; see panels/match/match.ts. */
function wasInRoom(): boolean {
  try {
    return Boolean(sessionStorage.matchRoom);
  } catch {
    return false;
  }
}

/** Fits the scene into the part of the page that nothing covers now. */
function layOut(app: App, stage: Stage): void {
  stage.view.camera.insets = freeOf();
  stage.view.resize();
  if (!app.state.camera) stage.view.camera.goHome();
  app.refresh();
}

/** The margins in CSS pixels of the part of the page that no controls cover. */
function freeOf(): { top: number; right: number; bottom: number; left: number } {
  // When the hint is closed, its space is used from the next scene on, so that the scene does not
  // move while the visitor's pointer is on it.
  const top = Math.max(...["top", "hint", score?.told ?? "top"].map((id) => atRest(id).bottom));
  const bottom = innerHeight - atRest("bottom").top;
  const dock = atRest("dock");
  const free = { top: top + 8, right: 16, bottom: bottom + 8, left: 16 };
  if (dock.width === 0) return free;
  // A narrow dock is beside the scene; on a phone it covers the lower part of the scene.
  if (dock.width < 0.6 * innerWidth) free.right = innerWidth - dock.left + 8;
  else free.bottom = innerHeight - dock.top + 8;
  return free;
}

/**
 * The bounds that an element will have when its CSS transition, which moves it into place, has
 * ended.
 */
function atRest(id: string): DOMRect {
  const { x, y, width, height } = byId(id).getBoundingClientRect();
  const glide = new DOMMatrix(getComputedStyle(byId(id)).transform);
  return new DOMRect(x - glide.e, y - glide.f, width, height);
}
