// A level of your own, drawn with the Tiled editor and dropped onto the page.

export const menu = null; // it is in no menu

export default async function ownLevel({ readLevel, buildLevel, readText }) {
  // Tilesets and templates of the map, if they were dropped with it.
  const open = (path) => readText(`own/${path}`);
  const level = await readLevel("own", await readText("own.tmj"), { skip: true, open });
  const saidOf = (wanted) => level.problems.filter(({ severity }) => severity === wanted);
  return {
    world: buildLevel(level),
    view: { x: level.camera[0], y: level.camera[1], height: level.cameraHeight },
    spawn: level.spawn,
    // What the file has and thud does not, is left out and told.
    notes: [
      ...saidOf("skip").map(({ text }) => `Left out: ${text}`),
      ...saidOf("note").map(({ text }) => `Note: ${text}`),
      ...Object.entries(level.classes).map(
        ([name, count]) =>
          `Note: the class “${name}” of ${count} ${count === 1 ? "object" : "objects"} means ` +
          "nothing here; each is what it is drawn as.",
      ),
    ],
  };
}
