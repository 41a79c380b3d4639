// Wheels and boulders roll over a mountain ridge in Tennessee: 403 heights as they were surveyed.
// The map was drawn in Tiled (www.mapeditor.org): properties there say what is heavy or rough.
// A figure walks among them, the one of the game Platformer.
import { Figure, WALK } from "./platformer_game/figure.js";

export const title = "Mountain walk";
export const about = "Walk along a real ridge in Tennessee among rolling wheels and boulders.";
export const menu = { group: "Levels from Tiled", place: 240 };

export default async function (setting) {
  const level = await setting.readLevel("mountain", await setting.readText("levels/mountain.tmj"));
  const world = setting.buildLevel(level);
  const figure = new Figure(setting, world, level);
  const [x, y] = level.camera;
  const scene = {
    world,
    view: { x, y, height: 0.6 * level.cameraHeight },
    spawn: level.spawn,
    keys: WALK,
    hidden: [figure.body.index],
    state: { figure: figure.startAt(level.spawn) },
    update: ({ held }) => figure.move(scene.state.figure, held),
    restored: () => figure.restore(scene.state.figure),
    paint: () => ({
      follow: scene.state.figure.place,
      marks: [figure.mark(scene.state.figure)],
    }),
  };
  return scene;
}
