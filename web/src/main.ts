/** The page: puts its parts together and starts the first scene. */
import { keepOffline } from "./offline/register";
import { App } from "./page/app";
import { addControls } from "./page/controls";
import { describeScene } from "./page/describe";
import { addDialogs } from "./page/dialogs";
import { Dock } from "./page/dock";
import { byId, make } from "./page/dom";
import { Figures } from "./page/figures";
import { addGallery, markScene } from "./page/gallery";
import { addHint } from "./page/hint";
import { Hud } from "./page/hud";
import { fail, messageOf, notice, say } from "./page/messages";
import { Pad } from "./page/pad";
import { Stage } from "./page/stage";
import { applyTheme, onTheme } from "./page/theme";
import { addTimeline } from "./page/timeline";
import { readState } from "./page/url";
import { panels } from "./panels/panels";
import { findScene, FIRST_SCENE } from "./scene/registry";
import { chooseWasm } from "./wasm/choose";

/** What runs a level that a visitor brings. */
const OWN_LEVEL = "own_level";

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
  try {
    stage = new Stage();
  } catch (error) {
    fail("Nothing can be drawn", messageOf(error), [], reload);
    return;
  }
  const app = new App(() => stage.look);
  stage.attach(app);
  // What takes room on the page is there before the engine is: nothing moves when it comes.
  const hud = new Hud();
  layOut(app, stage);
  const wasm = chooseWasm();
  try {
    await app.load(wasm);
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
    notice("This browser has no WebAssembly SIMD: everything works, at about half the speed.", 12);
  await assemble(app, stage, hud);
}

/** What a visitor need not wait for. */
function afterFirstPicture(app: App): void {
  performance.mark("first picture");
  app.client
    .ask("complete", {})
    .catch((error) => fail("A part of the engine is missing", messageOf(error), [], reload));
  void keepOffline((update) => {
    const button = make("button", {}, "Reload");
    button.addEventListener("click", update);
    notice("A new version of this page is ready. ", 60);
    byId("notice").append(button);
  });
}

const reload = { label: "Load the page again", go: () => location.reload() };

async function assemble(app: App, stage: Stage, hud: Hud): Promise<void> {
  const figures = new Figures();
  const pad = new Pad((held) => app.do({ kind: "keys", held }));
  const change = () => layOut(app, stage);
  const dock = new Dock(app, panels(stage), change);
  const openFile = async (file: File) => {
    const files = { "own.tmj": await file.text() };
    app.fileName = file.name.replace(/\.[^.]*$/, "");
    await app.open(OWN_LEVEL, { files });
  };
  addDialogs();
  addGallery({ choose: (entry) => void app.open(entry.name), openFile: (file) => void openFile(file) });
  addControls(app, stage, dock);
  addTimeline(app);
  describeScene(app);
  listenToScenes(app, { hud, figures, hinted: addHint(app) });
  app.listen({
    run({ keys }) {
      pad.show(keys);
      change();
    },
  });

  onTheme((dark) => stage.view.setTheme(dark));
  applyTheme();
  window.addEventListener("resize", change);

  const state = await readState(new URL(location.href));
  app.begin(state);
  let lastTime = 0;
  let pictured = false;
  const draw = (time: number) => {
    requestAnimationFrame(draw);
    const seconds = lastTime > 0 ? (time - lastTime) / 1000 : 0;
    lastTime = time;
    app.player.advance(seconds);
    app.requestFrame();
    stage.draw(seconds);
    const shown = app.player.shown;
    if (!shown) return;
    hud.show(shown.frame, seconds);
    if (!pictured) afterFirstPicture(app);
    pictured = true;
  };
  requestAnimationFrame(draw);
  await runFirst(app, state);
  if (state.panel) await dock.show(state.panel, false);
}

async function runFirst(app: App, { scene, size, seed, code, camera, claim }: Awaited<ReturnType<typeof readState>>): Promise<void> {
  const more = { size, seed, camera, claim };
  if (!scene) {
    await app.open(FIRST_SCENE, more);
    return;
  }
  if (findScene(scene)) {
    // Code from a link is another's: it runs when the visitor has read it and says so.
    await app.open(scene, more);
    if (code) app.offerCode(code);
    return;
  }
  fail("Not found", `There is no scene called “${scene}” here.`, [], {
    label: "Go to the first scene",
    go: () => void app.open(FIRST_SCENE),
  });
}

/** What is told of scenes. `hinted`: to whom a hint is shown the first scene tells nothing more. */
function listenToScenes(
  app: App,
  { hud, figures, hinted }: { hud: Hud; figures: Figures; hinted: boolean },
): void {
  let announced = "";
  app.listen({
    run(scene) {
      hud.reset();
      figures.reset();
      document.querySelector("main")!.removeAttribute("aria-busy");
      const { title, about } = app;
      byId("scene-title").textContent = title;
      byId("scenes-button").setAttribute("aria-label", `Scenes and levels; now: ${title}`);
      document.title = `${title} · thud`;
      markScene(app.state.scene);
      if (announced === app.state.scene) say(`${title}, from the beginning`);
      else {
        say(`${title}. ${about}`);
        if (!hinted || announced !== "") notice(about);
      }
      announced = app.state.scene;
      const [first, ...more] = scene.notes;
      if (first) notice(`${first}${more.length > 0 ? ` (and ${more.length} more)` : ""}`, 12);
    },
    frame: (frame) => figures.show(frame.paint),
    samples: (samples) => hud.add(samples),
    trouble(trouble, running) {
      // The code panel shows errors of the visitor's own text at their line.
      if (app.state.code !== null) return;
      const { message, details } = trouble;
      if (running) notice(`The scene stopped: ${message}`, 30);
      else
        fail("This scene cannot be run", message, details, {
          label: app.scene ? "Go back" : "Go to the first scene",
          go: () => void app.open(app.scene && app.lastGood ? app.lastGood : FIRST_SCENE),
        });
    },
    stuck() {
      fail(
        "The scene does not answer",
        "A step takes longer than eight seconds, or never ends. The page can wait on, or end it.",
        [],
        { label: "End it and start another scene", go: () => void app.revive(FIRST_SCENE) },
      );
    },
  });
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
  const top = byId("top").getBoundingClientRect().bottom;
  const bottom = innerHeight - byId("bottom").getBoundingClientRect().top;
  const dock = byId("dock").getBoundingClientRect();
  const free = { top: top + 8, right: 16, bottom: bottom + 8, left: 16 };
  if (dock.width === 0) return free;
  // Beside the scene where there is room, else a sheet over its lower part.
  if (dock.width < 0.6 * innerWidth) free.right = innerWidth - dock.left + 8;
  else free.bottom = innerHeight - dock.top + 8;
  return free;
}
