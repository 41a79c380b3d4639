// A heavy ball flies into towers of blocks and planks, one after the other.
// The map was drawn in Tiled (www.mapeditor.org): properties there say what is heavy or rough.

export const title = "Towers and a wrecking ball";
export const about = "A heavy ball flies into five towers of blocks.";
export const menu = { group: "Levels from Tiled", place: 230 };

export default async function ({ readText, readLevel, buildLevel }) {
  const level = await readLevel("towers", await readText("levels/towers.tmj"));
  const [x, y] = level.camera;
  return {
    world: buildLevel(level),
    view: { x: x - 9, y, height: level.cameraHeight, width: 98 },
    spawn: level.spawn,
  };
}
