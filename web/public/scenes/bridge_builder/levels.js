// The three gorges, which lie side by side, and what they ask for. Places of a bridge are on a
// grid: [column, row] from the left end of the road, which runs along row 0.

export const CELL = 2; // metres from one place of the grid to the next
export const ROWS = 2; // of the grid, above the road and below
export const ROAD_HALF = 0.15; // half the thickness of the road
const WALL = 0.35; // metres from a wall of the gorge to the ends of the bridge
const LAND = 20; // metres between two gorges
export const BED = -6.3; // metres: the bottom
const KNEE = -4.4; // down to there the walls are steep
export const VIEW = { y: 1.2, height: 15.5, width: 18 };

/** `stars`: who has so much money left gets two, and three. `anchors`: what holds a bridge. */
const GORGES = [
  {
    columns: 4,
    budget: 1000,
    stars: [200, 350],
    anchors: [[0, 0], [0, -1], [4, 0], [4, -1]],
    vehicle: "van",
  },
  {
    columns: 5,
    budget: 1500,
    stars: [200, 400],
    anchors: [[0, 0], [0, -2], [5, 0], [5, -1]],
    vehicle: "truck",
  },
  {
    columns: 7,
    budget: 2400,
    stars: [350, 750],
    anchors: [[0, 0], [0, -1], [0, -2], [7, 0], [7, 1]],
    vehicle: "hauler",
  },
];

let end = -LAND;
/** With x, where the gorge begins, and its width, both in metres. */
export const LEVELS = GORGES.map((gorge) => {
  const x = end + LAND;
  const width = gorge.columns * CELL;
  end = x + width;
  return { ...gorge, x, width };
});

/** Where in the world a place of the grid is. */
export function placeOf(level, [column, row]) {
  return [level.x + CELL * column, CELL * row];
}

/** The place of the grid that is nearest to one in the world. */
export function nearest(level, x, y) {
  const within = (value, low, high) => Math.min(high, Math.max(low, Math.round(value)));
  const column = within((x - level.x) / CELL, 0, level.columns);
  return [column, within(y / CELL, -ROWS, ROWS)];
}

/** The ground with its gorges; gives the body that bridges are tied to, in their walls. */
export function buildLand(world) {
  const ground = world.createBody();
  const points = [[-60, 9], [-30, 3], [-16, ROAD_HALF]];
  for (const { x, width } of LEVELS) {
    points.push([x - WALL - 0.2, ROAD_HALF], [x - WALL, KNEE], [x + 0.5, BED]);
    points.push([x + width / 2, BED + 0.3], [x + width - 0.5, BED]);
    points.push([x + width + WALL, KNEE], [x + width + WALL + 0.2, ROAD_HALF]);
  }
  const last = LEVELS.at(-1);
  const far = last.x + last.width;
  points.push([far + 16, ROAD_HALF], [far + 30, 4], [far + 60, 8]);
  world.createTerrain(ground, { kind: "irregular", points }, { friction: 0.9 });

  // A body apart from the ground: what hangs from it still meets the walls.
  const anchor = world.createBody();
  for (const { x, width } of LEVELS)
    for (const middle of [x - 0.6, x + width + 0.6]) {
      const lip = { halfWidth: 0.6, halfHeight: 2 * ROAD_HALF, offset: [middle, -ROAD_HALF] };
      world.createAabb(anchor, { ...lip, friction: 0.9 });
    }
  return anchor;
}
