/**
 * The panel Versus: runs the same scene in thud and in Box2D side by side, and compares the time
 * per step, the overlap, the joint gaps and the energy.
 */
import { version as box2dVersion } from "../../../node_modules/box2d3-wasm/package.json";
import { version as thudVersion } from "../../../package/package.json";
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { choiceBar, make } from "../../page/dom";
import type { Stage } from "../../page/stage";
import { onTheme } from "../../page/theme";
import { BOX2D_SUBSTEPS, SPLITS, type Versus } from "../../page/url";
import type { Frame } from "../../scene/frame";
import { messageOf } from "../../shared/error";
import "../../style/versus.css";
import { hasSimd } from "../../wasm/simd";
import { askForBox2D, endBox2D } from "../box2d-wish";
import { missesText } from "../misses";
import { engineColour, Plots, themeNow } from "./plots";
import { Table } from "./table";
import { ENGINES, Tally } from "./tally";
import { MEANING, movedText, verdict } from "./words";

/** Milliseconds between two updates: plots should move smoothly, figures be readable. Chosen. */
const PLOTS_EVERY = 150;
const TABLE_EVERY = 800;

/** The choices of the layout: label and hint of each. */
const LAYOUTS: { [split in Versus["split"]]: { label: string; title: string } } = {
  side: { label: "Two views", title: "Side by side; on a phone, one above the other" },
  over: { label: "Overlaid", title: "Box2D's bodies as outlines over thud's" },
  none: { label: "thud only", title: "Box2D runs and is measured, but is not drawn" },
};

export function createPanel(app: App, stage: Stage): Panel {
  return new VersusPanel(app, stage);
}

class VersusPanel implements Panel {
  readonly element = make("div", { id: "versus" });
  readonly #tally = new Tally(crossOriginIsolated);
  readonly #table = new Table(crossOriginIsolated);
  readonly #plots = new Plots(this.#tally);
  readonly #verdict = make("p", { class: "verdict" });
  readonly #trouble = make("p", { class: "trouble", role: "alert" });
  readonly #tryAgain = make("button", { class: "wide" }, "Try again");
  readonly #since = make("p", { class: "quiet" });
  readonly #moved = make("p", { class: "moved" });
  readonly #measured = make("div");
  #open = false;
  /** Box2D has been requested and is not ready yet. */
  #loading = false;
  /** The settings of the present comparison as JSON; other settings begin a new one. */
  #settings = "";
  readonly #showPlots = throttled(PLOTS_EVERY, () => this.#plots.show());
  readonly #showTable = throttled(TABLE_EVERY, () => this.#showFigures());

  constructor(
    private readonly app: App,
    private readonly stage: Stage,
  ) {
    this.#build();
    const colour = () => {
      for (const engine of ENGINES)
        this.element.style.setProperty(`--${engine}`, engineColour(engine, themeNow()));
    };
    onTheme(colour);
    colour();
    app.listen({
      run: () => void this.#restart(),
      frame: (frame) => this.#open && this.#heed(frame),
      samples: (samples) => {
        if (!this.#open) return;
        this.#tally.add(samples, app.scene?.timeStep ?? 1 / 60);
        this.#showPlots();
        this.#showTable();
      },
      state: () => this.#open && this.#choose(),
    });
  }

  opened(): Promise<void> {
    this.#open = true;
    this.stage.split = this.app.state.versus.split;
    this.#plots.begin(this.app.scene?.lengthScale ?? 1);
    return this.#restart();
  }

  closed(): void {
    this.#open = false;
    this.stage.split = "none";
    this.app.refresh();
    endBox2D(this.app);
  }

  /** Builds the panel's elements. */
  #build(): void {
    const { app } = this;
    const { versus } = app.state;
    const layout = choiceBar(
      "split",
      "Layout",
      "",
      SPLITS.map((value) => ({ value, ...LAYOUTS[value] })),
      (split) => {
        versus.split = this.stage.split = split;
        app.chosen();
      },
    );
    layout.show(versus.split);
    const substeps = choiceBar(
      "box2d-substeps",
      "Box2D’s substeps",
      "its manual recommends 4",
      BOX2D_SUBSTEPS.map((value) => ({ value: String(value), label: String(value) })),
      (value) => {
        versus.substeps = BOX2D_SUBSTEPS.find((known) => String(known) === value)!;
        app.chosen();
        void this.#ask();
      },
    );
    substeps.show(String(versus.substeps));
    const again = make("button", { class: "wide" }, "Restart both");
    again.addEventListener("click", () => void app.restart());
    this.#tryAgain.addEventListener("click", () => void this.#restart());
    const table = this.#table.element;
    this.#measured.append(table, this.#moved, this.#since, again, this.#plots.element);
    // The layout bar is above the verdict, whose changing number of lines moves what is below it.
    this.element.append(
      layout.element,
      this.#verdict,
      make("p", { class: "meaning" }, MEANING),
      this.#trouble,
      this.#tryAgain,
      this.#measured,
      substeps.element,
      notes(),
    );
  }

  /** Begins a new comparison at the present step, as a scene starts or the panel opens. */
  async #restart(): Promise<void> {
    if (!this.#open) return;
    this.#tally.clear();
    this.#choose();
    await this.#ask();
  }

  /** Requests Box2D with the chosen substeps, and shows that it loads or why it cannot. */
  async #ask(): Promise<void> {
    this.#loading = true;
    this.#tell(null);
    try {
      await askForBox2D(this.app);
      this.#loading = false;
      this.#tell(null);
    } catch (error) {
      this.#loading = false;
      if (this.#open) this.#tell(messageOf(error));
    }
    this.app.refresh();
  }

  /** Shows the settings; if they have changed, a new comparison begins. */
  #choose(): void {
    const { choices, versus } = this.app.state;
    const thud = choices.substeps > 0 ? `${choices.substeps} substeps` : choices.quality;
    const box2d = `${versus.substeps} ${versus.substeps === 1 ? "substep" : "substeps"}`;
    this.#table.setSettings(thud, box2d);
    const settings = JSON.stringify([choices, versus.substeps]);
    if (settings !== this.#settings) this.#tally.clear();
    this.#settings = settings;
    this.#showFigures();
    this.#plots.show();
  }

  /** Shows an error of Box2D that came with a frame, or hides it once Box2D runs again. */
  #heed({ box2dTrouble, box2d }: Frame): void {
    if (box2dTrouble) this.#tell(box2dTrouble);
    else if (box2d && !this.#trouble.hidden) this.#tell(null);
  }

  /** Shows why Box2D does not run, in place of the figures; null: it runs or is being loaded. */
  #tell(trouble: string | null): void {
    this.#trouble.hidden = this.#tryAgain.hidden = trouble === null;
    this.#measured.hidden = this.#verdict.hidden = trouble !== null;
    const text = trouble === null ? "" : `${trouble} The scene goes on with thud alone.`;
    if (this.#trouble.textContent !== text) this.#trouble.textContent = text;
    this.#showFigures();
  }

  /** Updates the table, the verdict and the notes on the comparison. */
  #showFigures(): void {
    const tally = this.#tally;
    const { state, scene } = this.app;
    const figures = { thud: tally.figures("thud"), box2d: tally.figures("box2d") };
    const lengthScale = scene?.lengthScale ?? 1;
    const misses = missesText(tally.misses);
    this.#table.show(tally.since === null ? null : figures, lengthScale, misses === "");
    this.#verdict.textContent = this.#loading
      ? `Loading Box2D… ${this.app.player.waiting ? "Both begin together." : "thud runs alone."}`
      : tally.since === null && state.paused
        ? "The scene stands still: run it, and both are measured."
        : misses || verdict(figures.thud, figures.box2d, lengthScale);
    const moved = movedText(Math.hypot(...tally.origin) / lengthScale);
    this.#moved.hidden = moved === "";
    if (this.#moved.textContent !== moved) this.#moved.textContent = moved;
    this.#since.hidden = !tally.since;
    const seconds = ((tally.since ?? 0) * (scene?.timeStep ?? 1 / 60)).toFixed(2);
    this.#since.textContent =
      `Box2D began at ${seconds} s, as a copy of thud’s world at that moment. ` +
      "Restart both for the same start.";
  }
}

/** The folded explanation of how both engines are measured. */
function notes(): HTMLElement {
  const simd = hasSimd() ? "with SIMD" : "without SIMD";
  const clock = crossOriginIsolated
    ? "Single steps are timed: this page is isolated from others, so its clock is fine."
    : "This host does not isolate the page from others, so that its clock ticks in 0.1 ms: " +
      "times are averages over many steps.";
  const items = [
    `thud ${thudVersion} and Box2D v3 (box2d3-wasm ${box2dVersion}), both as WebAssembly ` +
      `${simd}, on one thread, in turn in the same worker.`,
    clock,
    "Overlap is measured for both by the same code, sleeping bodies included. Where that takes " +
      "long it is done every few steps.",
    "Times are of steps in which both engines have bodies awake, after the first 30.",
    "Both get the same bodies, joints, pulls, explosions and craters, each by where its own " +
      "bodies are. A game’s character is moved in thud and pushes bodies in both.",
    "What a scene does to its world is done to Box2D’s too. What Box2D is not given, such as gears, " +
      "water or a listener of contacts, is named above, and nothing is compared then. A joint that " +
      "can break does so in each engine by what it bears there.",
    "Pairs that the scene lets through, by a rule, a filter or a listener, count as no overlap.",
    "After going back in time Box2D begins anew, as a copy of thud’s world.",
  ];
  return make(
    "details",
    {},
    make("summary", {}, "How this is measured"),
    make("ul", {}, ...items.map((item) => make("li", {}, item))),
  );
}

/** A function that calls `act` some milliseconds after it is called, at most once in that time. */
function throttled(milliseconds: number, act: () => void): () => void {
  let timer = 0;
  return () => {
    timer ||= window.setTimeout(() => {
      timer = 0;
      act();
    }, milliseconds);
  };
}
