// Air hockey: the rink, its puck and two mallets, and one step of the game. The scene's world and
// the worlds of both peers are made and stepped by this alone, so that the same inputs give the
// same bits in each.

/** The middle of the left rink, and the way from there to the right one. */
export const MIDDLE = -5.75;
export const APART = 11.5;
/** Half the length and the width of the ice, half the goal, and both radii. */
export const LONG = 5;
export const WIDE = 3;
export const GOAL = 0.9;
export const PUCK = 0.3;
export const MALLET = 0.45;
export const TIME_STEP = 1 / 60;

/** Of a mallet, length/s; and the share of its way that it goes in a second, while it is near. */
const FASTEST = 8;
const EAGER = 12;

export const OPTIONS = { gravity: [0, 0], timeStep: TIME_STEP, sleeping: false, maximumSpeed: 14 };

/** Builds both rinks, and the puck and the mallets in the left one: their handles, the puck first. */
export function build(world) {
  for (const middle of [MIDDLE, MIDDLE + APART]) {
    const wall = (x, y, halfWidth, halfHeight) => (
      { kind: "aabb", offset: [x, y], halfWidth, halfHeight, restitution: 0.9, friction: 0 }
    );
    const long = [-1, 1].map((side) => wall(0, side * (WIDE + 0.25), LONG + 0.5, 0.25));
    const ends = [-1, 1].flatMap((x) =>
      [-1, 1].map((y) => wall(x * (LONG + 0.25), y * 0.5 * (WIDE + GOAL), 0.25, 0.5 * (WIDE - GOAL))),
    );
    world.createBody({ position: [middle, 0], shapes: [...long, ...ends] });
  }
  const round = (radius) => [{ kind: "circle", radius, restitution: 0.9, friction: 0 }];
  return [
    world.createBody({
      ...{ kind: "dynamic", position: [MIDDLE, 0], velocity: [-3, 1.2] },
      ...{ linearDamping: 0.1, fixedRotation: true, shapes: round(PUCK) },
    }),
    ...[-1, 1].map((side) =>
      world.createBody({ kind: "kinematic", position: [MIDDLE + side * 3.8, 0], shapes: round(MALLET) }),
    ),
  ];
}

/** An input is a place that a mallet makes for, on a grid, as one number. */
const FINE = 16;
const SPAN = 8;

export function inputOf([x, y]) {
  const cell = (value) => Math.round((Math.min(SPAN, Math.max(-SPAN, value)) + SPAN) * FINE);
  return cell(x) * 1024 + cell(y);
}

/** The place of an input, relative to the rink's middle, held to the player's half. */
function placeOf(input, side) {
  const [x, y] = [Math.floor(input / 1024) / FINE - SPAN, (input % 1024) / FINE - SPAN];
  const [near, far] = [MALLET, LONG - MALLET];
  const ahead = Math.min(far, Math.max(near, side === 0 ? -x : x));
  return [side === 0 ? -ahead : ahead, Math.min(WIDE - MALLET, Math.max(MALLET - WIDE, y))];
}

/** Before a step: the mallets go to where the inputs say. */
export function steer(world, bodies, inputs) {
  inputs.forEach((input, side) => {
    const [x, y] = world.positionOf(bodies[1 + side]);
    const [toX, toY] = placeOf(input, side);
    const [dx, dy] = [(toX + MIDDLE - x) * EAGER, (toY - y) * EAGER];
    const slower = Math.min(1, FASTEST / (Math.hypot(dx, dy) || 1));
    world.setVelocity(bodies[1 + side], [dx * slower, dy * slower]);
  });
}

/** After a step: a puck that has left the ice is given to the player who let it in. */
export function judge(world, [puck], game) {
  const [x, y] = world.positionOf(puck);
  if (Math.abs(x - MIDDLE) < LONG + 0.4 && Math.abs(y) < WIDE + 0.2) return;
  const loser = x < MIDDLE ? 0 : 1;
  game.score[1 - loser]++;
  world.setTransform(puck, [MIDDLE, 0]);
  const turn = (game.score[0] + game.score[1]) % 3 - 1;
  world.setVelocity(puck, [loser === 0 ? -3 : 3, 1.1 * turn + 0.3]);
}
