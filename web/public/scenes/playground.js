// Swings, a seesaw, a big wheel, and a car that drives over a rope bridge and a drawbridge.
// The map was drawn in Tiled (www.mapeditor.org): an object there whose class is "hinge", "wheel"
// or another kind of joint ties two bodies, which its properties a and b refer to.

export const title = "Playground";
export const about = "Swings, a seesaw, a big wheel and a car on bridges: all of it hangs on joints.";
export const menu = { group: "Levels from Tiled", place: 215 };

export default async function ({ readText, readLevel, buildLevel }) {
  const level = await readLevel("playground", await readText("levels/playground.tmj"));
  const [x, y] = level.camera;
  return {
    world: buildLevel(level),
    view: { x, y, height: level.cameraHeight, width: 60 },
    spawn: level.spawn,
  };
}
