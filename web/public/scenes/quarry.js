// Rubble of every size and weight slides down the benches of a quarry. One stone in nine is of ore,
// six times as heavy.
// The map was drawn in Tiled (www.mapeditor.org): properties there say what is heavy or rough.

export const title = "Quarry";
export const about = "Rubble of every size and weight slides down the benches of a quarry.";
export const menu = { group: "Levels from Tiled", place: 210 };

export default async function ({ readText, readLevel, buildLevel }) {
  const level = await readLevel("quarry", await readText("levels/quarry.tmj"));
  const [x, y] = level.camera;
  return {
    world: buildLevel(level),
    view: { x, y, height: level.cameraHeight },
    spawn: level.spawn,
  };
}
