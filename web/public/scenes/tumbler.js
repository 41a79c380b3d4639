// A drum turns without end and churns boxes; none escapes.

export const title = "Tumbler";
export const about = "A turning drum tumbles boxes without end; none escapes.";
export const menu = { group: "In motion", place: 450 };
export const size = { means: "boxes", usual: 2000, least: 1, most: 100000 };

export default function (setting) {
  return drumOf(setting, (world, body) =>
    world.createObb(body, { halfWidth: 0.125, halfHeight: 0.125 }),
  );
}

// With a load of bodies, whose shapes `addShape` makes: the i-th gets its own.
export function drumOf({ createWorld, grid, size }, addShape) {
  const spacing = 0.28;
  const columns = Math.ceil(Math.sqrt(size));
  const inner = Math.max(1, columns * 0.22); // half the drum's width inside
  const world = createWorld();

  // The drum is one kinematic body of four walls: nothing that is in it can slow it down.
  const turn = 0.4363323129985824; // 25 degrees a second
  const position = [0, grid(inner)];
  const drum = world.createBody({ kind: "kinematic", position, angularVelocity: turn });
  const [thin, long] = [0.5, inner + 1];
  for (const x of [inner + thin, -inner - thin])
    world.createObb(drum, { halfWidth: thin, halfHeight: long, offset: [x, 0] });
  for (const y of [inner + thin, -inner - thin])
    world.createObb(drum, { halfWidth: long, halfHeight: thin, offset: [0, y] });

  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing;
    const y = (Math.floor(i / columns) - 0.5 * (columns - 1)) * spacing + inner;
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    addShape(world, body, i);
  }

  const view = { x: 0, y: inner, height: 3.2 * inner, width: 3 * inner };
  return { world, view, spawn: [0, inner] };
}
