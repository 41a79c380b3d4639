/** Describes the running scene in words, for screen readers. */
import type { Frame } from "../scene/frame";
import type { App } from "./app";
import { byId } from "./dom";
import { count, length } from "./format";

/** Milliseconds between two updates while the scene runs. A screen reader reads the text when the
 * scene gets the focus; changes are not announced. Chosen. */
const REFRESH = 3000;

/** Keeps the text of the element "state" up to date. */
export function describeScene(app: App): void {
  let last = -Infinity;
  const tell = () => {
    const frame = app.player.shown?.frame;
    if (!frame || !app.scene) return;
    last = performance.now();
    const seconds = frame.step * app.scene.timeStep;
    byId("state").textContent = inWords(app.title, app.state.paused, seconds, frame);
  };
  app.listen({
    run: () => (last = -Infinity),
    frame() {
      // While paused, each frame is described at once, as when the visitor moves the time slider.
      if (app.state.paused || performance.now() - last >= REFRESH) tell();
    },
    state: tell,
  });
  tell();
}

/** "Pyramid, running at 12.3 s; 5,050 bodies, 120 awake; deepest overlap 0.004." */
function inWords(
  title: string,
  paused: boolean,
  seconds: number,
  { stats, error, paint }: Pick<Frame, "stats" | "error" | "paint">,
): string {
  const awake = stats.awakeBodies === 0 ? "all asleep" : `${count(stats.awakeBodies)} awake`;
  const overlap =
    error.penetrationMax > 0 ? `deepest overlap ${length(error.penetrationMax)}` : "no overlap";
  const begun = seconds > 0;
  const figures = (paint?.figures ?? []).map(({ label, value }) => `${label} ${value}`);
  const bodies = `${count(stats.bodies)} ${stats.bodies === 1 ? "body" : "bodies"}`;
  // Before the first step no body counts as awake and no overlap has been measured.
  const parts = [
    begun || !paused
      ? `${title}, ${paused ? "paused" : "running"} at ${seconds.toFixed(1)} s`
      : `${title}, not begun: Space, or the button Pause, runs it`,
    ...(begun ? [`${bodies}, ${awake}`, overlap] : [bodies]),
    ...(figures.length > 0 ? [figures.join(", ")] : []),
  ];
  return `${parts.join("; ")}.${paint?.message ? ` ${paint.message}` : ""}`;
}
