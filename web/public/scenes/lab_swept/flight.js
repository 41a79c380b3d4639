// A ball in free flight, thrown again and again, and the same flight computed.

export const RADIUS = 0.15;
const FROM = [-5.8, -3.4];
const VELOCITY = [4.6, 7];
/** The flight ends after so many seconds, or where the ball is this low. */
const [LONGEST, LOWEST] = [2.5, -4];
/** Steps that the ball’s trace stays when the flight is over. */
const REST = 60;

/** Where the parabola is after so many seconds. */
export function placeAt(gravity, seconds) {
  return [
    FROM[0] + VELOCITY[0] * seconds,
    FROM[1] + VELOCITY[1] * seconds - 0.5 * gravity * seconds * seconds,
  ];
}

/** `update` throws the ball when it is time or a setting has changed; `look` tells of its flight. */
export function createFlight(world, state) {
  const ball = world.createBody({ kind: "dynamic", position: FROM, maySleep: false, detection: "swept" });
  world.createCircle(ball, { radius: RADIUS });
  const throwBall = () => {
    world.setTimeStep(state.step);
    world.setGravity([0, -state.gravity]);
    world.setTransform(ball, FROM);
    world.setVelocity(ball, VELOCITY);
    state.trace = [FROM];
  };
  throwBall();
  return {
    slot: ball.index,
    update(step) {
      const thrown = [state.gravity, state.step].join();
      if (thrown === state.thrown && step < state.next) return;
      state.thrown = thrown;
      state.next = step + stepsOf(state) + REST;
      throwBall();
    },
    stepped() {
      if (state.trace.length <= stepsOf(state))
        state.trace = [...state.trace, world.bodyStateOf(ball).position];
    },
    look: () => lookAt(state),
  };
}

/** The number of steps until the flight ends, at least one. */
function stepsOf({ gravity, step }) {
  let count = 1;
  while (count * step < LONGEST && placeAt(gravity, count * step)[1] > LOWEST) count++;
  return count;
}

function lookAt(state) {
  const { gravity, step, trace } = state;
  const count = stepsOf(state);
  const corners = Array.from({ length: count + 1 }, (_, i) => placeAt(gravity, i * step));
  // The step in which the ball is highest shows the gap best.
  const top = Math.min(count - 1, gravity > 0 ? Math.floor(VELOCITY[1] / gravity / step) : 0);
  const chord = [0, 1].map((k) => 0.5 * (corners[top][k] + corners[top + 1][k]));
  const curve = placeAt(gravity, (top + 0.5) * step);
  // A ball whose settings have just changed is thrown in the next step.
  const isOfThese = [gravity, step].join() === state.thrown;
  const misses = isOfThese
    ? trace.map(([x, y], i) => Math.hypot(x - placeAt(gravity, i * step)[0], y - placeAt(gravity, i * step)[1]))
    : [];
  return {
    corners,
    chord,
    curve,
    trace: isOfThese ? trace : [],
    sagitta: (gravity * step * step) / 8,
    gap: curve[1] - chord[1],
    miss: Math.max(0, ...misses),
    gravity,
    seconds: count * step,
  };
}
