// Stairs, planks and lifts, drawn in Tiled (www.mapeditor.org). Walk among crates and balls.
// Figures of the map that nobody steers fall and are pushed like anything else.
import { DROP, Figure, WALK } from "./platformer_game/figure.js";
import { grassOn } from "./platformer_game/grass.js";
import { findLifts, turnLifts } from "./platformer_game/lifts.js";

export const title = "Stairs, planks and lifts";
export const about = "Walk among crates and balls through a level drawn in Tiled.";
export const menu = { group: "Levels from Tiled", place: 220 };

export default async function (setting) {
  const level = await setting.readLevel("platform", await setting.readText("levels/platform.tmj"));
  const world = setting.buildLevel(level);
  const lifts = findLifts(world);
  const grass = grassOn(world);
  const figure = new Figure(setting, world, level);
  const [x, y] = level.camera;
  const scene = {
    world,
    view: { x, y, height: 0.7 * level.cameraHeight },
    spawn: level.spawn,
    keys: { ...WALK, ...DROP },
    hidden: [figure.body.index],
    state: { figure: figure.startAt(level.spawn) },
    update({ held }) {
      turnLifts(world, lifts);
      figure.move(scene.state.figure, held);
    },
    restored: () => figure.restore(scene.state.figure),
    paint: () => ({
      follow: scene.state.figure.place,
      marks: [...grass, figure.mark(scene.state.figure)],
    }),
  };
  return scene;
}
