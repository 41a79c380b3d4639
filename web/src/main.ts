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

/** What runs a level that a visitor brings. */
const OWN_LEVEL = "own_level";
/** What plays a recording that a visitor brings. */
const RECORDING = "recording";
/** Where code is shown, and its errors. */
const CODE_PANEL = "code";
/** Where a scene's controls are. */
const VALUES_PANEL = "values";
/** Where a game is shared with others; it comes with the games that can be. */
const MATCH_PANEL = "match";
/** The part of its time from which on a scene runs in slow motion. */
const MUCH_LAG = 0.2;
/** Milliseconds that code which does not answer is left to the visitor to end. */
const LONGEST_STUCK = 10_000;
/** Milliseconds that the first scene stands still for a panel that comes with it. */
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
  loaded.catch(() => {}); // it is awaited below, or, where nothing can be drawn, not at all
  try {
    stage = new Stage(await createRenderer(byId<HTMLCanvasElement>("bodies")));
  } catch (error) {
    fail("Nothing can be drawn", messageOf(error), [], reload);
    return;
  }
  stage.attach(app);
  // What takes room on the page is there before the engine is: nothing moves when it comes.
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

/** What a visitor need not wait for. */
function afterFirstPicture(app: App, loadGallery: () => void): void {
  performance.mark("first picture");
  app.client
    .ask("complete", {})
    .catch((error) => fail("A part of the engine is missing", messageOf(error), [], reload))
    .finally(loadGallery);
  // Without it the page works, but not without a network.
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
        // What is shown may stand still, so that no other frame brings its figures.
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
  // A link to other code in the same page: browsers do not load the page again for it.
  window.addEventListener("hashchange", () => history.state ?? location.reload());
  // Back and forward between scenes.
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

/** What tells how games are played; the gallery brings it with what it tells of scenes. */
let how: Pick<typeof import("./page/how"), "howToPlay" | "isTouch"> | null = null;

/** Shows the figures and the message of a game; comes with the gallery. */
let score: InstanceType<typeof import("./page/score").Score> | null = null;

let slow: Promise<void> | null = null;

/** Tells that the scene has stopped by an error, and offers a recording of what led to it. */
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

/** Most scenes never come to that. */
function tellSlow(app: App): void {
  slow ??= import("./page/slow").then(({ watch }) => watch(app));
}

/** A panel that compares or records begins with the scene's first step, if it comes in time. */
function waitForPanel({ player }: App): void {
  player.waiting = true;
  setTimeout(() => (player.waiting = false), LONGEST_WAIT);
}

/** Addresses that were read one after the other: the last one counts. */
let addressesRead = 0;

/** Null where the visitor has gone on to another address meanwhile. */
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
  // Code from a link is another's, unless it was written in this tab: it runs when the visitor has
  // read it and says so.
  const more = { size, seed, camera, claim, level, invite };
  const draft = code && readDraft(scene) === code ? code : null;
  if (!draft || !(await app.open(scene, { ...more, code: draft }))) await app.open(scene, more);
  if (code && !draft) app.offerCode(code);
  tellStill(app);
  if (code === null)
    notice("The code in this link is damaged, so the page’s own scene runs.", 20);
}

/** Whoever asked for less motion finds a scene that waits, and is told how it runs. */
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
 * What is told of scenes: what to look at, how to play, what is wrong. `hinted`: a hint is shown;
 * `change` lays the page out anew.
 */
function listenToScenes(
  app: App,
  parts: { dock: Dock; hud: Hud; hinted: boolean; change(): void },
): void {
  const { dock, hud, change } = parts;
  let { hinted } = parts;
  let announced = "";
  /** A scene has begun of which nothing is told yet; its first frame is there; it speaks itself;
   * its buttons do. */
  let [untold, framed, speaks, worded] = [false, false, false, false];
  const tell = () => {
    if (!untold || !framed || !app.abouts || !how) return;
    untold = false;
    const { about } = app;
    const play = worded && how.isTouch() ? "" : how.howToPlay(app.scene!.keys);
    const text = `${speaks ? "" : about} ${play}`.trim();
    if ((speaks || (hinted && !play)) && about) say(about);
    // To whom a hint is shown, the first scene tells nothing more but how it is played.
    if (text && (play || !hinted) && byId("notice").hidden) notice(text, play ? 15 : 7);
    hinted = false;
  };
  /** Takes back what was told of a scene that could not be run, or did not answer. */
  let takeBack = () => {};
  /** What lists the notes of scenes, once one has some. */
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
      // Other code may have other keys, and the same title.
      const played = title + JSON.stringify(scene.keys);
      untold = announced !== played;
      framed = false;
      say(untold ? title : `${title}, from the beginning`);
      // What was told of the scene before is not of this one.
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
      // A scene that has a message of its own says by itself what to do.
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
          // What ran before has never stopped.
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
        // What never ends may take ever more memory, and the whole tab with it.
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
 * A scene that begins opens the panel that it asks for. Values comes with a scene that has some to
 * set, and goes with it. `comes`: the visitor is invited to a match, or may come back to one.
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
  // On a phone the panel would stand over the game's buttons.
  if (shared && (comes || matchMedia("(width >= 40em)").matches)) void dock.show(MATCH_PANEL, false);
  else if (panel) void dock.show(panel === "contacts" ? "inside" : panel, false);
  else if (has) void dock.show(VALUES_PANEL, false);
}

/** Whether this tab was in a match that it may come back to; see panels/match/match.ts. */
function wasInRoom(): boolean {
  try {
    return Boolean(sessionStorage.matchRoom);
  } catch {
    return false;
  }
}

/** Fits the scene into what the page leaves free now. */
function layOut(app: App, stage: Stage): void {
  stage.view.camera.insets = freeOf();
  stage.view.resize();
  if (!app.state.camera) stage.view.camera.goHome();
  app.refresh();
}

/** What the controls leave free of the page. */
function freeOf(): { top: number; right: number; bottom: number; left: number } {
  // A hint that is closed gives its room back with the next scene: nothing moves under a hand.
  const top = Math.max(...["top", "hint", score?.told ?? "top"].map((id) => atRest(id).bottom));
  const bottom = innerHeight - atRest("bottom").top;
  const dock = atRest("dock");
  const free = { top: top + 8, right: 16, bottom: bottom + 8, left: 16 };
  if (dock.width === 0) return free;
  // Beside the scene where there is room, else a sheet over its lower part.
  if (dock.width < 0.6 * innerWidth) free.right = innerWidth - dock.left + 8;
  else free.bottom = innerHeight - dock.top + 8;
  return free;
}

/** Where an element will stand that may still be gliding into its place. */
function atRest(id: string): DOMRect {
  const { x, y, width, height } = byId(id).getBoundingClientRect();
  const glide = new DOMMatrix(getComputedStyle(byId(id)).transform);
  return new DOMRect(x - glide.e, y - glide.f, width, height);
}
