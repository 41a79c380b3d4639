// Wheels and boulders roll over a mountain ridge in Tennessee: 403 heights as they were surveyed.
// The map was drawn in Tiled (www.mapeditor.org); its properties say what is heavy, rough or moving.

export default async function ({ readText, readLevel, buildLevel }) {
  const level = readLevel("mountain", await readText("levels/mountain.tmj"));
  const [x, y] = level.camera;
  return {
    world: buildLevel(level),
    view: { x, y, height: level.cameraHeight },
    spawn: level.spawn,
  };
}
