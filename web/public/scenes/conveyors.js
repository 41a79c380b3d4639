// Belts that stand still, but whose surface runs: `surfaceSpeed`. What falls off the lowest one is
// put back on top.

export const title = "Conveyor belts";
export const about = "Conveyor belts carry parcels to and fro, and round again.";
export const menu = { group: "In motion", place: 430 };
export const size = { means: "parcels", usual: 120, least: 1, most: 2000 };

// Middle and height of each belt, and how fast it runs to the right.
const BELTS = [
  { x: -2, y: 9, surfaceSpeed: 3 },
  { x: 4, y: 5.5, surfaceSpeed: -4 },
  { x: -2, y: 2, surfaceSpeed: 5 },
  { x: 4, y: -1.5, surfaceSpeed: -6 },
];
const HALF_LENGTH = 9;

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld();
  for (const { x, y, surfaceSpeed } of BELTS) {
    const belt = world.createBody({ position: [x, y] });
    const surface = { surfaceSpeed, friction: 0.8 };
    world.createAabb(belt, { halfWidth: HALF_LENGTH, halfHeight: 0.3, ...surface });
  }
  for (const x of [-16, 18]) {
    const wall = world.createBody({ position: [x, 6] });
    world.createAabb(wall, { halfWidth: 0.5, halfHeight: 12 });
  }

  const chance = random(seed + 1);
  const parcels = Array.from({ length: size }, (_, i) => {
    const x = -8 + 1.2 * (i % 10) + chance(-0.1, 0.1);
    const position = [grid(x), 11 + 1.2 * Math.floor(i / 10)];
    const parcel = world.createBody({ kind: "dynamic", position });
    const half = chance(0.2, 0.45);
    if (i % 4 === 0) world.createCircle(parcel, { radius: half });
    else world.createObb(parcel, { halfWidth: half, halfHeight: chance(0.2, 0.45) });
    return parcel;
  });

  return {
    world,
    view: { x: 1, y: 4, height: 18, width: 36 },
    spawn: [-6, 13],
    update({ step }) {
      for (const parcel of parcels) {
        if (!world.isValid(parcel) || world.bodyStateOf(parcel).position[1] > -8) continue;
        // Somewhere above the first belt, and each time elsewhere.
        world.setTransform(parcel, [-9 + ((parcel.index + step) % 12) * 0.5, 14]);
        world.setVelocity(parcel, [0, 0]);
      }
    },
  };
}
