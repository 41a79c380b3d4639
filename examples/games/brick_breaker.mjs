/**
 * Brick breaker. Every third brick drops a capsule, which widens the paddle that catches it. The
 * game is won when no brick is left, and lost with the third ball.
 */
import { aabb, circle, walls } from "thud";

export const title = "Brick breaker";
export const about = "Clear forty bricks with three balls; capsules widen the paddle.";
export const menu = { group: "Games", place: 131 };

const [PADDLE, BRICK, BALL, CAPSULE, PIT] = [2, 4, 8, 16, 32]; // categories
const SPEED = 14; // of the ball, length/s
const FASTEST = 0.3; // the paddle's way in a step
const FLOOR = -9; // where the paddle moves
const ROWS = ["bad", "accent", "gold", "good", "water"]; // colours
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

export default function ({ createWorld }) {
  const world = createWorld({ gravity: [0, 0], detection: "swept" });
  const game = {
    world,
    view: { x: 0, y: 0.6, height: 23, width: 18 },
    keys: { left: "move", right: "move", fire: "throw the ball", restart: "play again" },
    pointer: true,
    state: begin(),

    /** Before each step: moves the paddle, and throws a ball if there is none. */
    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      const [x] = world.positionOf(state.paddle);
      if (held.left || held.right) state.aim = x + FASTEST * (held.right - held.left);
      else if (pointer && pointer.x !== state.pointed) state.aim = state.pointed = pointer.x;
      const to = clamp(state.aim, 8 - halfWidth(state));
      world.setTarget(state.paddle, [x + clamp(to - x, FASTEST), FLOOR]);
      if (state.ball || state.over || !(held.fire || pointer?.down)) return;
      state.ball = addDisc(BALL, ~CAPSULE, [x, FLOOR + 0.7], [0.3 * SPEED, 0.95 * SPEED]);
    },

    /** After each step, when the world tells who has met whom. */
    stepped() {
      const { state } = game;
      for (const { a: brick } of world.eventPairs(BRICK, BALL)) {
        const place = world.positionOf(brick.body);
        if (--state.left % 3 === 0) state.capsules.push(addDisc(CAPSULE, PADDLE | PIT, place, [0, -4]));
        world.destroy(brick.body);
      }
      for (const { a: capsule, b: paddle } of world.eventPairs(CAPSULE, PADDLE)) {
        world.destroy(capsule.body);
        state.caught++;
        world.setHalfExtents(paddle.shape, halfWidth(state), 0.3);
      }
      // The ball leaves at an angle that grows with its distance from the paddle's middle.
      for (const { a: paddle, b: ball } of world.eventPairs(PADDLE, BALL)) {
        const off = world.positionOf(ball.body)[0] - world.positionOf(paddle.body)[0];
        const angle = Math.atan(off);
        world.setVelocity(ball.body, [SPEED * Math.sin(angle), SPEED * Math.cos(angle)]);
      }
      for (const { b: lost } of world.eventPairs(PIT, BALL | CAPSULE)) {
        if (lost.category === BALL) state.balls--;
        world.destroy(lost.body);
      }
      if (state.left === 0 && state.ball && world.isValid(state.ball)) world.destroy(state.ball);
      state.bricks = state.bricks.filter(({ body }) => world.isValid(body));
      state.capsules = state.capsules.filter((capsule) => world.isValid(capsule));
      if (state.ball && !world.isValid(state.ball)) state.ball = null;
      else if (state.ball) keepFalling(state.ball);
      state.over = state.left === 0 || state.balls === 0;
    },

    /** What to draw over the bodies, and what to say. */
    paint() {
      const { state } = game;
      const at = (body) => {
        const [x, y] = world.positionOf(body);
        return { x, y };
      };
      const box = (halfWidth, halfHeight, ink) => ({ kind: "box", halfWidth, halfHeight, ink, filled: true });
      const disc = (ink) => ({ kind: "circle", radius: 0.3, ink, filled: true });
      const [x] = world.positionOf(state.paddle);
      return {
        marks: [
          ...state.bricks.map(({ body, row }) => ({ ...box(0.9, 0.4, ROWS[row]), ...at(body) })),
          ...state.capsules.map((capsule) => ({ ...disc("good"), ...at(capsule) })),
          { ...box(halfWidth(state), 0.3, "player"), ...at(state.paddle) },
          ...(state.over ? [] : [{ ...disc("ink"), ...(state.ball ? at(state.ball) : { x, y: FLOOR + 0.7 }) }]),
        ],
        figures: [
          { label: "Bricks", value: String(state.left) },
          { label: "Balls", value: String(state.balls) },
          { label: "Capsules", value: String(state.caught) },
        ],
        message: message(state),
      };
    },
  };
  return game;

  /** Builds all bodies anew. Returns the game's own data. */
  function begin() {
    for (const body of world.bodies()) world.destroy(body);
    const pit = aabb(9, 1, { offset: [0, -13], category: PIT, sensor: true });
    world.createBody({ shapes: [...walls(8, 13, 1, { offset: [0, -1.5] }), pit] });
    const places = Array.from({ length: 40 }, (_, i) => [(i % 8) * 2 - 7, 4 + Math.floor(i / 8)]);
    const bodies = world.createBodies({ shapes: [aabb(0.9, 0.4, { category: BRICK })] }, places);
    const bricks = bodies.map((body, i) => ({ body, row: ROWS.length - 1 - Math.floor(i / 8) }));
    const shapes = [aabb(1, 0.3, { category: PADDLE })];
    const paddle = world.createBody({ kind: "kinematic", position: [0, FLOOR], shapes });
    const bodiesOf = { paddle, bricks, ball: null, capsules: [] };
    return { ...bodiesOf, left: bricks.length, balls: 3, caught: 0, aim: 0, pointed: null, over: false };
  }

  /** A ball or a capsule that bounces without loss. Returns its body. */
  function addDisc(category, mask, position, velocity) {
    const shapes = [circle(0.3, { category, mask, restitution: 1, friction: 0 })];
    return world.createBody({ kind: "dynamic", position, velocity, fixedRotation: true, shapes });
  }

  /** A ball that flies almost level would never come back. */
  function keepFalling(ball) {
    const { velocity: [vx, vy] } = world.velocityOf(ball);
    if (Math.abs(vy) < 2) world.setVelocity(ball, [vx, vy < 0 ? -2 : 2]);
  }
}

const halfWidth = ({ caught }) => 1 + 0.25 * Math.min(caught, 8);

function message({ left, balls, caught, ball, over }) {
  if (over && left === 0) return `All bricks are gone, ${balls} ${balls === 1 ? "ball is" : "balls are"} left. Restart to play again.`;
  if (over) return `No ball is left, ${left} bricks are. Restart to try again.`;
  if (!ball) return "Clear all bricks: move, and throw the ball.";
  return caught > 0 ? "Each capsule widens the paddle." : "Every third brick drops a capsule: catch it.";
}

/** A computer player: what it holds in the next step. */
export function robot({ world, state }) {
  if (!state.ball) return { held: { fire: true } };
  // It moves the paddle so that the ball hits it where it is sent to a brick.
  const [ballX] = world.positionOf(state.ball);
  const [brickX, brickY] = world.positionOf(state.bricks[0].body);
  return { pointer: { x: ballX - clamp((brickX - ballX) / (brickY + 9), 0.9), y: FLOOR, down: false } };
}
