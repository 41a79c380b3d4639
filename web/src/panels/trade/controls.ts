/**
 * The controls of the panel Trade: quality, substeps, limit of overlap, detection and broadphase,
 * which trade speed for accuracy, steps per second and the greatest speed, which bound what bisection
 * may miss, and the size of the scene.
 */
import { BROADPHASES, QUALITIES, type Broadphase, type Quality } from "thud";
import type { App } from "../../page/app";
import { choiceBar, make } from "../../page/dom";
import { DETECTION_CHOICES, MAX_ERRORS, STEP_RATES, TOP_SPEEDS } from "../../page/url";
import { createBound } from "./bound";
import { createDetectionCount } from "./detection";
import { countText } from "./text";

const QUALITY_TEXTS: Readonly<Record<Quality, string>> = {
  draft: "2 substeps, the quickest. Tall stacks sink and fall; heavy loads crush light bodies.",
  default: "4 substeps, for most games. Piles that give way by more than 1 % are solved directly.",
  high: "8 substeps. All piles that are not too large are solved directly: stacks stand still.",
  exact: "16 substeps, every pile solved directly, each impact by itself. The dearest.",
};

/** Substeps per step at each quality, as in the engine. */
const QUALITY_SUBSTEPS: Readonly<Record<Quality, number>> = {
  draft: 2,
  default: 4,
  high: 8,
  exact: 16,
};

type DetectionChoice = (typeof DETECTION_CHOICES)[number];

const DETECTION_TEXTS: Readonly<Record<DetectionChoice, string>> = {
  auto: "Up to the quality: swept at exact, continuous otherwise.",
  overlap: "Tests where shapes are at the start of a step. Cheapest; fast bodies pass walls.",
  continuous: "Fast bodies stop at fixed shapes. As cheap as overlap until one is fast.",
  bisect:
    "Goes back to the time of each collision, found by halving the step. Very fast bodies pass " +
    "walls. Dear where many bodies touch: the plane above tells how dear here.",
  swept:
    "Moves from collision to collision, exactly. Nothing passes walls. Dear where many bodies " +
    "touch: the plane above tells how dear here.",
};

const BROADPHASE_TEXTS: Readonly<Record<Broadphase, string>> = {
  grid: "Cells of a grid for each size of body: quick however large the world is.",
  sweep: "Bodies sorted along x: good where little moves, and in crowds.",
  sweep_y: "The same along y: good where bodies stand one above the other.",
  sweep_widest: "The same along the axis on which bodies are spread more widely.",
  sweep_both: "Sorted along x and y: each body takes the list with fewer others to test.",
  all: "Every shape against every other: quickest for a few dozen.",
};

/** A choice bar with a line below it that describes the chosen value. */
function explained<T extends string>(
  name: string,
  legend: string,
  hint: string,
  texts: Readonly<Record<T, string>>,
  values: readonly T[],
  act: (value: T) => void,
): { element: HTMLElement; show(value: T): void } {
  const choices = values.map((value) => ({ value, label: value, title: texts[value] }));
  const bar = choiceBar(name, legend, hint, choices, act);
  const line = make("p", { class: "explained" });
  bar.element.append(line);
  return {
    element: bar.element,
    show(value) {
      bar.show(value);
      line.textContent = texts[value];
    },
  };
}

export interface Slider {
  element: HTMLElement;
  input: HTMLInputElement;
  /** Moves the slider to a place. `text`: the value's text if the place is only near it. */
  show(place: number, text?: string): void;
}

/** A slider with the places 0 to `most`. `textOf` gives the text of a place; `act` is called with
 * the place when the visitor releases the slider. */
export function slider(
  name: string,
  label: string,
  hint: string,
  most: number,
  textOf: (place: number) => string,
  act: (place: number) => void,
): Slider {
  const input = make("input", { type: "range", id: name, min: 0, max: most, step: 1 });
  const output = make("output", { for: name });
  const tell = (text: string) => {
    output.textContent = text;
    input.setAttribute("aria-valuetext", text);
  };
  input.addEventListener("input", () => tell(textOf(Number(input.value))));
  input.addEventListener("change", () => act(Number(input.value)));
  const head = make("label", { for: name }, `${label} `, make("small", {}, hint));
  const element = make("div", { class: "slider" }, make("div", {}, head, output), input);
  return {
    element,
    input,
    show(place, text) {
      input.value = String(place);
      tell(text ?? textOf(place));
    },
  };
}

/** Places of the slider of sizes, which is logarithmic. Chosen. */
const SIZE_PLACES = 200;

/** Builds the controls; they set the app's choices and follow them. */
export function createControls(app: App): HTMLElement {
  const { choices } = app.state;
  const quality = explained("quality", "Quality", "", QUALITY_TEXTS, QUALITIES, (value) =>
    app.choose({ quality: value }),
  );
  const detection = explained(
    "detection",
    "Detection",
    "restarts the scene",
    DETECTION_TEXTS,
    DETECTION_CHOICES,
    (value) => app.choose({ detection: value }),
  );
  const broadphase = explained(
    "broadphase",
    "Broadphase",
    "restarts the scene",
    BROADPHASE_TEXTS,
    BROADPHASES,
    (value) => app.choose({ broadphase: value }),
  );
  const substeps = slider(
    "substeps",
    "Substeps",
    "in each step",
    64,
    (place) =>
      place > 0 ? String(place) : `the quality’s ${QUALITY_SUBSTEPS[choices.quality]}`,
    (place) => app.choose({ substeps: place }),
  );
  const maxError = slider(
    "max-error",
    "Overlap limit",
    "more is solved directly",
    MAX_ERRORS.length - 1,
    (place) => (place > 0 ? `${MAX_ERRORS[place]} length scales` : "none"),
    (place) => app.choose({ maxError: MAX_ERRORS[place] }),
  );
  const stepRate = slider(
    "step-rate",
    "Steps a second",
    "restarts the scene",
    STEP_RATES.length - 1,
    (place) => (place > 0 ? String(STEP_RATES[place]) : "the scene’s"),
    (place) => app.choose({ stepRate: STEP_RATES[place] }),
  );
  const topSpeed = slider(
    "top-speed",
    "Greatest speed",
    "restarts the scene",
    TOP_SPEEDS.length - 1,
    (place) => (place > 0 ? `${TOP_SPEEDS[place]} length scales a second` : "the scene’s"),
    (place) => app.choose({ topSpeed: TOP_SPEEDS[place] }),
  );
  const noSolver = "Draft has no direct solver that could keep to a limit.";
  const draftNote = make("p", { class: "explained" }, noSolver);
  const size = createSize(app);

  const show = () => {
    quality.show(choices.quality);
    detection.show(choices.detection);
    broadphase.show(choices.broadphase);
    substeps.show(choices.substeps);
    maxError.show(MAX_ERRORS.findIndex((value) => value === choices.maxError));
    stepRate.show(STEP_RATES.findIndex((value) => value === choices.stepRate));
    topSpeed.show(TOP_SPEEDS.findIndex((value) => value === choices.topSpeed));
    maxError.input.disabled = choices.quality === "draft";
    draftNote.hidden = choices.quality !== "draft";
  };
  app.listen({ state: show });
  show();
  const sliders = make("div", { class: "sliders" }, substeps.element, maxError.element, draftNote);
  return make(
    "div",
    { class: "trade-controls" },
    quality.element,
    sliders,
    detection.element,
    createDetectionCount(app),
    make("div", { class: "sliders" }, stepRate.element, topSpeed.element, createBound(app)),
    broadphase.element,
    size,
  );
}

/** The slider of the scene's size; hidden if the scene has one size only. */
function createSize(app: App): HTMLElement {
  const range = () => {
    const { least = 1, most = 1 } = app.scene?.sizes ?? {};
    return { least: Math.max(1, least), most };
  };
  const sizeAt = (place: number): number => {
    const { least, most } = range();
    const size = least * (most / least) ** (place / SIZE_PLACES);
    // Rounded to two significant digits, except at the ends of the range.
    return place === SIZE_PLACES ? most : Math.max(least, Math.round(Number(size.toPrecision(2))));
  };
  const control = slider(
    "size",
    "Size",
    "restarts the scene",
    SIZE_PLACES,
    (place) => `${countText(sizeAt(place))} ${app.scene?.sizes?.means ?? ""}`,
    (place) => {
      app.state.size = sizeAt(place);
      void app.restart();
    },
  );
  const show = () => {
    const sizes = app.scene?.sizes ?? null;
    control.element.hidden = sizes === null;
    if (!sizes || !app.scene) return;
    const { least, most } = range();
    const part = most > least ? Math.log(app.scene.size / least) / Math.log(most / least) : 0;
    const place = Math.round(Math.min(1, Math.max(0, part)) * SIZE_PLACES);
    control.show(place, `${countText(app.scene.size)} ${sizes.means}`);
  };
  app.listen({ run: show });
  show();
  return make("div", { class: "sliders" }, control.element);
}
