/**
 * Runs a game without a window, played by its robot: `node run.js pool`. What it prints is what the
 * game says at its end.
 */
import { pathToFileURL } from "node:url";
import { load } from "thud";
import { settingOf, stepOf } from "./step.js";

/** Plays a game to its end, or for so many steps. Returns it. */
export async function play(name, most = 20_000) {
  const { default: setUp, robot } = await import(`./${name}.mjs`);
  const game = await setUp(settingOf(await load()));
  for (let step = 0; !game.state.over && step < most; step++) stepOf(game, step, robot(game));
  return game;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const { world, state, paint } = await play(process.argv[2] ?? "pool");
  const { figures, message } = paint();
  console.log(figures.map(({ label, value }) => `${label}: ${value}`).join(", "));
  console.log(message);
  console.log(`${world.stats().steps} steps, ${world.hash()}`);
  process.exitCode = state.over ? 0 : 1;
}
