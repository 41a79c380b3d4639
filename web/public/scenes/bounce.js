// Eleven balls fall from the same height. Their restitution goes from 0, which stops dead, to 1,
// which should come back to the dashed line for ever.

export const title = "Bouncing";
export const about = "Balls of restitution 0 to 1: the last should bounce as high for ever.";
export const menu = { group: "In motion", place: 490 };

const COUNT = 11;
const HEIGHT = 10;

export default function ({ createWorld }) {
  const world = createWorld();
  world.createTerrain(world.createBody(), { kind: "flat" });
  for (let i = 0; i < COUNT; i++) {
    const position = [2 * (i - 5), HEIGHT];
    const ball = world.createBody({ kind: "dynamic", position, maySleep: false });
    world.createCircle(ball, { radius: 0.5, restitution: i / (COUNT - 1) });
  }

  const line = [[-11, HEIGHT], [11, HEIGHT]];
  const labels = Array.from({ length: COUNT }, (_, i) => ({
    kind: "text",
    x: 2 * (i - 5),
    y: -0.8,
    text: (i / (COUNT - 1)).toFixed(1),
    ink: "ink",
  }));
  return {
    world,
    view: { x: 0, y: 5, height: 14, width: 26 },
    spawn: [0, 12],
    paint: () => ({
      marks: [{ kind: "line", points: line, ink: "soft", dashed: true }, ...labels],
    }),
  };
}
