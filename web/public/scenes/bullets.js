// Bullets of 10 m/s to 100 km/s, each in a closed room of its own with walls 2 cm thick. The
// fastest cross their room 70 times in a step. None gets out.

export const title = "Bullets at thin walls";
export const about = "Bullets of up to 100 km/s bounce between walls 2 cm thick; none gets out.";
export const menu = { group: "In motion", place: 510 };
export const size = { means: "bullets", usual: 15, least: 1, most: 1000 };

const SPEEDS = [1e1, 1e2, 1e3, 1e4, 1e5];
const NAMES = ["10 m/s", "100 m/s", "1 km/s", "10 km/s", "100 km/s"];
const LEGIBLE = 30; // rooms; the names of more would overlap
const MATERIAL = { friction: 0.1, restitution: 0.9 };

export default function ({ createWorld, grid, size }) {
  const [thin, halfWidth, halfHeight] = [0.01, 12, 0.9];
  const world = createWorld({ gravity: [0, 0] });

  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, ...MATERIAL });
  };

  const bullets = [];
  for (let i = 0; i < size; i++) {
    const y = (0.5 * (size - 1) - i) * 2;
    wall(0, y - halfHeight, halfWidth, thin);
    wall(0, y + halfHeight, halfWidth, thin);
    wall(-halfWidth, y, thin, halfHeight);
    wall(halfWidth, y, thin, halfHeight);

    const speed = SPEEDS[i % 5];
    const kind = ["circle", "aabb", "obb"][Math.floor(i / 5) % 3];
    const bullet = world.createBody({
      kind: "dynamic",
      position: [-halfWidth + 1, y],
      velocity: [speed, 0.01 * speed],
      angularVelocity: kind === "obb" ? 5 : 0,
    });
    const box = { halfWidth: 0.15, halfHeight: 0.1, ...MATERIAL };
    if (kind === "circle") world.createCircle(bullet, { radius: 0.1, ...MATERIAL });
    else if (kind === "aabb") world.createAabb(bullet, box);
    else world.createObb(bullet, box);
    bullets.push({ bullet, room: y, name: NAMES[i % 5] });
  }

  const paint = () => {
    const seen = bullets.map(({ bullet, room, name }) => {
      const [x, y] = world.bodyStateOf(bullet).position;
      return { x, y, room, name };
    });
    const isOut = ({ x, y, room }) => Math.abs(x) > halfWidth || Math.abs(y - room) > halfHeight;
    return {
      figures: [{ label: "Out of its room", value: `${seen.filter(isOut).length} of ${size}` }],
      marks: [
        ...(size > LEGIBLE ? [] : seen).map(({ room, name }) => {
          return { kind: "text", x: 0, y: room, text: name, ink: "soft", size: 12 };
        }),
        ...seen.map(({ x, y }) => ({ kind: "circle", x, y, radius: 0.4, ink: "accent" })),
      ],
    };
  };
  return { world, view: { x: 0, y: 0, height: 2.2 * size }, spawn: [-20, 0], paint };
}
