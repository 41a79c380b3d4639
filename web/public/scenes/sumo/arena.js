// The platform: a middle that stays, and pieces at both ends that fall one after the other.

const MIDDLE = 2.4; // half its length
const PIECE = 1.2; // the length of each other piece
const THICK = 0.35; // half

/** `half`: half the platform’s length; `pieces`: those at the ends, by pairs from outside inwards. */
export function buildArena(world, size) {
  const pairs = size + 2;
  const surface = { friction: 0.9 };
  const box = (x, halfWidth) => {
    const shapes = [{ kind: "aabb", halfWidth, halfHeight: THICK, ...surface }];
    return { body: world.createBody({ position: [x, -THICK], shapes }), x };
  };
  box(0, MIDDLE);
  const pieces = [];
  for (let i = pairs - 1; i >= 0; i--)
    pieces.push([-1, 1].map((side) => box(side * (MIDDLE + PIECE * (i + 0.5)), 0.5 * PIECE)));
  return {
    half: MIDDLE + PIECE * pairs,
    pieces,
    /** Half the length that is left when so many pairs have fallen. */
    left: (fallen) => MIDDLE + PIECE * (pairs - fallen),
    drop(world, pair) {
      for (const { body } of pieces[pair]) world.setKind(body, "dynamic");
    },
    mend(world) {
      for (const { body, x } of pieces.flat()) {
        world.setKind(body, "static");
        world.setTransform(body, [x, -THICK]);
      }
    },
  };
}
