// A level of your own, drawn with the Tiled editor and dropped onto the page.
export default async function ownLevel({ readLevel, buildLevel, readText }) {
  const level = await readLevel("own", await readText("own.tmj"), { skip: true });
  return {
    world: buildLevel(level),
    view: { x: level.camera[0], y: level.camera[1], height: level.cameraHeight },
    spawn: level.spawn,
    // What the file has and thud does not, is left out and told.
    notes: level.problems.map(({ text }) => `Left out: ${text}`),
  };
}
