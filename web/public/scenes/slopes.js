// Discs roll and boxes slide down slopes of 10, 20, 30 and 40 degrees. A box of this friction, 0.5,
// begins to slide at 26.6 degrees: only those on the two steep slopes do.

export const title = "Rolling and sliding";
export const about =
  "Discs roll down four slopes; of the boxes only those on the two steep ones slide.";
export const menu = { group: "In motion", place: 500 };
export const size = { means: "length of each slope", usual: 20, least: 6, most: 1000 };

// Angle, cosine and sine: written out, because Math.cos may differ between browsers.
const SLOPES = [
  { degrees: 10, angle: 0.17453292519943295, run: 0.984807753012208, rise: 0.17364817766693036 },
  { degrees: 20, angle: 0.3490658503988659, run: 0.9396926207859084, rise: 0.3420201433256687 },
  { degrees: 30, angle: 0.5235987755982989, run: 0.8660254037844386, rise: 0.5 },
  { degrees: 40, angle: 0.6981317007977318, run: 0.766044443118978, rise: 0.6427876096865393 },
];
const friction = 0.5;
const half = 0.5;

export default function ({ createWorld, grid, size: length }) {
  const spacing = length + 14;
  const world = createWorld();
  world.createTerrain(world.createBody(), { kind: "flat", slope: 0 });

  SLOPES.forEach(({ angle, run, rise }, i) => {
    const x = (i - 0.5 * SLOPES.length) * spacing;
    const top = length * rise;
    const points = [[-4, top], [0, top], [length * run, 0]];
    const ramp = world.createBody({ position: [x, 0] });
    world.createTerrain(ramp, { kind: "irregular", points }, { friction });

    // So far down the ramp, and from there half a size along its normal.
    const onRamp = (along, turned) =>
      world.createBody({
        kind: "dynamic",
        position: [
          grid(x + along * run + half * rise),
          grid(top - along * rise + half * run),
        ],
        angle: turned,
      });
    world.createCircle(onRamp(3, 0), { radius: half, friction });
    world.createObb(onRamp(1, -angle), { halfWidth: half, halfHeight: half, friction });
  });

  const marks = SLOPES.map(({ degrees, run }, i) => ({
    kind: "text",
    x: (i - 0.5 * SLOPES.length) * spacing + 0.5 * length * run,
    y: -0.07 * length,
    text: `${degrees}°`,
    ink: "ink",
  }));
  // From before the first slope to where a disc rolls after the last.
  const [left, right] = [-0.5 * SLOPES.length * spacing - 5, 2 * spacing - 8];
  return {
    world,
    view: {
      x: 0.5 * (left + right),
      y: 0.3 * length,
      height: 1.2 * length,
      width: right - left,
    },
    spawn: [0, length],
    paint: () => ({ marks }),
  };
}
