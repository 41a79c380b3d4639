/**
 * A line in the panel Trade on the bound of bisection and of overlap testing: a body whose speed ×
 * time step is less than the thickness of the thinnest shape cannot pass through a shape. Red where
 * the greatest speed of the world does not keep it.
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";

/** Milliseconds between two questions to the worker for the limit, which changes with the shapes of
 * the world. Chosen. */
const REFRESH = 1000;

/** Creates the line; it is hidden while the world has no shape. */
export function createBound(app: App): HTMLElement {
  const line = make("p", { class: "explained", id: "bisection-bound" });
  /** When the limit was last asked for, on the clock of performance.now(). */
  let asked = 0;
  const ask = () => {
    asked = performance.now();
    void app.client.ask("bisectionLimit", {}).then(show, () => {});
  };
  /** `limit`: World.bisectionLimit, world units per second. */
  const show = (limit: number) => {
    const { scene } = app;
    line.hidden = !scene || !Number.isFinite(limit);
    if (!scene || line.hidden) return;
    const { timeStep, lengthScale } = scene;
    // The greatest speed bounds x and y of a velocity, each by itself.
    const speed = Math.SQRT2 * app.state.choices.topSpeed * lengthScale;
    line.classList.toggle("broken", speed >= limit);
    line.textContent = boundText(speed, timeStep, limit);
  };
  app.listen({
    run: ask,
    frame() {
      if (line.offsetParent !== null && performance.now() - asked > REFRESH) ask();
    },
  });
  if (app.scene) ask();
  return line;
}

/** `speed`: the greatest along a diagonal, or 0 where it is the scene's own. */
function boundText(speed: number, timeStep: number, limit: number): string {
  const thinnest = `${figure(limit * timeStep)}, the thinnest shape`;
  if (speed === 0)
    return `Bisection is sure up to ${figure(limit)} a second: speed × step is then below ${thinnest}.`;
  const product = `${figure(speed)} along a diagonal × ${figure(timeStep)} s = ${figure(speed * timeStep)}`;
  return speed < limit
    ? `Kept: ${product} is below ${thinnest}. Bisection misses no body that does not turn.`
    : `Broken: ${product} is not below ${thinnest}. Bisection may miss what is passed.`;
}

const figure = (value: number): string => String(Number(value.toPrecision(3)));
