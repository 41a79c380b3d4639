/** The panel Options: speed, theme, threads, random seed, files of what was seen, and a link to the
 * present view. */
import type { App } from "../page/app";
import { choiceBar, make } from "../page/dom";
import type { Panel } from "../page/dock";
import { notice } from "../page/messages";
import { applyTheme, chosenTheme, chooseTheme, THEMES } from "../page/theme";
import { LONGEST_LEVEL, SPEEDS } from "../page/url";
import { messageOf } from "../shared/error";

/** Numbers of threads that are offered, up to the processors of the machine. Chosen. */
const THREADS = [1, 2, 3, 4, 6, 8, 12, 16];

/**
 * Loads the engine with so many threads into a new worker, and starts the scene again. Resolves to
 * their number, which is 1 where they cannot be had.
 */
async function useThreads(app: App, threads: number): Promise<number> {
  const used = await app.reload({ ...app.wasm, threads: threads > 1 ? threads : undefined });
  app.client.ask("complete", {}).catch(() => {}); // the first call that needs it tries again
  return used;
}

/** The bar that shows and chooses the number of threads. */
function createThreadBar(app: App): HTMLElement {
  /** The number of choices so far: of one that is replaced while it loads, nothing is told. */
  let choices = 0;
  const most = crossOriginIsolated && app.wasm.simd ? navigator.hardwareConcurrency : 1;
  const bar = choiceBar(
    "threads",
    "Threads",
    most > 1 ? "for large scenes; the same bits with any number" : "this page cannot share memory",
    THREADS.filter((count) => count <= most).map((count) => ({ value: String(count), label: String(count) })),
    async (value) => {
      const choice = ++choices;
      try {
        const used = await useThreads(app, Number(value));
        if (choice === choices) bar.show(String(used));
      } catch (error) {
        if (choice !== choices) return;
        notice(`The engine with threads cannot be loaded: ${messageOf(error)}`);
        bar.show(String(await useThreads(app, 1)));
      }
    },
  );
  bar.show(String(app.wasm.threads ?? 1));
  return bar.element;
}

/** What the copied link contains. A level whose packed text is too long is missing in it. */
function carried({ state: { level } }: App): string {
  if (!level) return "scene, choices, view and code.";
  return location.hash.includes("level=")
    ? "level, choices, view and code."
    : `choices and view, but not the level, which is over ${LONGEST_LEVEL / 1000} kB even packed. ` +
        "Send its file too.";
}

export function createPanel(app: App): Panel {
  const speed = choiceBar(
    "speed",
    "Speed",
    "times real time",
    SPEEDS.map((value) => ({ value: String(value), label: `${value}×` })),
    (value) => app.setSpeed(Number(value)),
  );
  const theme = choiceBar(
    "theme",
    "Theme",
    "",
    THEMES.map((value) => ({ value, label: value })),
    (value) => {
      chooseTheme(value);
      applyTheme();
    },
  );
  theme.show(chosenTheme());
  const seed = make("input", {
    type: "number",
    id: "seed",
    min: 0,
    max: 999999999,
    step: 1,
    inputmode: "numeric",
  });
  seed.addEventListener("change", () => {
    if (!seed.checkValidity() || seed.value === "") return;
    app.state.seed = Number(seed.value);
    void app.restart();
  });
  const share = make("button", { class: "wide", id: "share" }, "Copy a link to what you see");
  share.addEventListener("click", () => {
    void navigator.clipboard.writeText(location.href).then(
      () => notice(`The link is in the clipboard: ${carried(app)}`),
      () => notice("The clipboard is not allowed here: copy the address from the address bar."),
    );
  });
  const record = make(
    "button",
    { class: "wide", id: "record", title: "From the first step that the time slider reaches to this one" },
    "Save a recording",
  );
  const video = make(
    "button",
    { class: "wide", id: "save-video", title: "All that the time slider reaches, played once more" },
    "Save a video",
  );
  const saves = (button: HTMLButtonElement, act: () => Promise<void>) =>
    button.addEventListener("click", async () => {
      record.disabled = video.disabled = true;
      try {
        await act();
      } catch (error) {
        notice(`A part of the page cannot be loaded: ${messageOf(error)}`);
      }
      record.disabled = video.disabled = false;
      // A button that is disabled loses the focus.
      if (document.activeElement === document.body) button.focus();
    });
  saves(record, async () => (await import("../page/recording")).saveRecording(app));
  saves(video, async () => (await import("../page/film")).saveVideo(app));
  video.hidden = typeof MediaRecorder !== "function";
  const element = make(
    "div",
    {},
    speed.element,
    theme.element,
    createThreadBar(app),
    make(
      "fieldset",
      {},
      make("legend", {}, make("label", { for: "seed" }, "Random seed")),
      seed,
    ),
    make(
      "fieldset",
      {},
      make(
        "legend",
        {},
        "What you saw ",
        make("small", {}, "a recording is opened again under Scenes, any step of it"),
      ),
      record,
      video,
    ),
    make("div", { class: "section" }, share),
  );
  const show = () => {
    speed.show(String(app.state.speed));
    seed.value = String(app.state.seed);
  };
  app.listen({ state: show });
  show();
  return { element };
}
