// Bullets and sheets of paper, a lane for each detection. All are fired alike, again and again.

export const LANES = ["overlap", "bisect", "swept"];
export const RADIUS = 0.1;
export const START = -6;
export const HALF_HEIGHT = 0.35;
const [FIRST, PITCH] = [-4.1, 1.15];

/** The bullets stay for so many steps where they have come to. */
const REST = 60;

export const heightOf = (lane) => FIRST - lane * PITCH;

/**
 * `update` fires the bullets when it is time or when a setting has changed; `look` tells how they
 * fare, and what the bound says.
 */
export function createRange(world, geometry, thud, state) {
  const lanes = LANES.map((detection, i) => {
    const sheet = world.createBody({ position: [0, heightOf(i)], detection });
    const bullet = world.createBody({
      kind: "dynamic",
      position: [START, heightOf(i)],
      maySleep: false,
      detection,
    });
    const material = { friction: 0, restitution: 0 };
    world.createCircle(bullet, { radius: RADIUS, ...material });
    const paper = world.createAabb(sheet, { halfWidth: 0.1, halfHeight: HALF_HEIGHT, ...material });
    return { detection, bullet, paper, y: heightOf(i) };
  });
  const fire = () => {
    world.setTimeStep(1 / state.rate);
    for (const { bullet, paper, y } of lanes) {
      world.setHalfExtents(paper, 0.5 * state.thickness, HALF_HEIGHT);
      world.setTransform(bullet, [START, y]);
      world.setVelocity(bullet, [state.speed, 0]);
    }
  };
  fire();
  return {
    update(step) {
      const shot = [state.rate, state.speed, state.thickness].join();
      if (shot === state.shot && step < state.next) return;
      state.shot = shot;
      state.next = step + Math.ceil((-2 * START * state.rate) / state.speed) + REST;
      fire();
    },
    look() {
      const motion = state.speed / state.rate;
      // What is set is in the world from the next step on: the bound is told of what is set.
      const thinnest = Math.min(state.thickness, 2 * RADIUS);
      return {
        motion,
        thinnest,
        bisectable: motion < thinnest,
        limit: thinnest * state.rate,
        poses: posesInPaper(geometry, thud, state, motion),
        lanes: lanes.map(({ detection, bullet, y }) => {
          const { position, velocity } = world.bodyStateOf(bullet);
          return { detection, y, x: position[0], outcome: outcomeOf(position[0], velocity[0], state) };
        }),
      };
    },
  };
}

function outcomeOf(x, speed, state) {
  if (x > 0.5 * state.thickness) return "passes";
  return speed < 0.5 * state.speed ? "is caught" : "flies";
}

/** At how many steps a bullet that nothing stops overlaps the paper. */
function posesInPaper(geometry, thud, state, motion) {
  const reach = 0.5 * state.thickness + RADIUS;
  const [first, last] = [-reach, reach].map((x) => (x - START) / motion);
  const paper = { kind: "aabb", center: [0, 0], halfWidth: 0.5 * state.thickness, halfHeight: HALF_HEIGHT };
  let count = 0;
  for (let i = Math.floor(first); i <= Math.ceil(last); i++) {
    const bullet = { kind: "circle", center: [START + i * motion, 0], radius: RADIUS };
    if (geometry.closest(thud, paper, bullet).overlaps) count++;
  }
  return count;
}
