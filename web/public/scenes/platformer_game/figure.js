// A figure to play with on levels whose length scale is that of the world: it runs, jumps, drops
// through planks, rides lifts and pushes crates. What it remembers from step to step is plain data,
// which the scene keeps in its `state`, so that time can go back.
//
// Two kindnesses that players take for granted: a jump counts a moment after the ground is gone,
// and a moment before it is there.

/** What keys do. */
export const WALK = { left: "walk", right: "walk", up: "jump" };
export const DROP = { down: "drop through planks" };

// In length scales, and seconds.
const HALF_WIDTH = 0.35;
const HALF_HEIGHT = 0.75;
const RUN_SPEED = 8;
const RUN_GAIN = 60; // of speed per second, on the ground
const AIR_GAIN = 35;
const JUMP_HEIGHT = 3.2;
const GRAVITY_MORE = 1.6; // than what falls by itself has: jumps feel light otherwise
const FALL_SPEED = 25;
const CUT_SHORT = 0.45; // of the rise is left where the key is let go
const KINDNESS = 0.1;
const PUSH = 60; // force, for bodies of density 1
const ONE_WAY = 2; // the category of planks
const STEP = 1 / 60;

export class Figure {
  #mover;
  #world;
  #unit;
  #gravity;

  // `level` as the package's readLevel gives it.
  constructor({ createMover }, world, { spawn, gravity, lengthScale }) {
    this.#world = world;
    this.#unit = lengthScale;
    this.#gravity = GRAVITY_MORE * Math.hypot(...gravity);
    this.halfWidth = HALF_WIDTH * lengthScale;
    this.halfHeight = HALF_HEIGHT * lengthScale;
    const box = { halfWidth: this.halfWidth, halfHeight: this.halfHeight };
    // Crates and balls meet it as this body.
    this.body = world.createBody({ kind: "kinematic", position: spawn });
    world.createAabb(this.body, box);
    this.#mover = createMover(world, {
      shape: { kind: "aabb", ...box },
      position: spawn,
      pushForce: PUSH * lengthScale ** 3,
      body: this.body,
      oneWay: ONE_WAY,
    });
  }

  // What it is like as it begins at a place, in the air.
  startAt([x, y]) {
    this.#mover.place([x, y]);
    // Set there, not led there: it would throw about whatever stands between.
    this.#world.setTransform(this.body, [x, y]);
    this.#world.setVelocity(this.body, [0, 0]);
    return {
      place: [x, y],
      velocity: [0, 0],
      facing: 1,
      ground: null, // the velocity of what it stands on
      rising: false, // by a jump whose key is still held
      jumpWasHeld: false,
      sinceGround: 1, // seconds
      sinceJumpKey: 1,
      mover: this.#mover.state(),
    };
  }

  // Moves it by a step, as `held` says (see Input in web/src/scene/scene.ts).
  move(state, held) {
    this.#steer(state, held);
    this.#jump(state, Boolean(held.up || held.fire));
    const report = this.#mover.move(state.velocity, STEP, { drop: held.down });
    state.place = report.position;
    state.velocity = report.velocity;
    state.ground = report.ground && report.ground.velocity;
    state.mover = this.#mover.state();
  }

  // Its body stays where it is.
  stop() {
    this.#world.setVelocity(this.body, [0, 0]);
  }

  // After `state` has become an earlier one.
  restore(state) {
    this.#mover.restore(state.mover);
  }

  // How it is drawn after the step: what carries it has moved on since it moved itself.
  mark({ place: [x, y], facing, ground }, ink = "player") {
    const [vx, vy] = ground ?? [0, 0];
    const { halfWidth, halfHeight } = this;
    const [seenX, seenY] = [x + vx * STEP, y + vy * STEP];
    return { kind: "figure", x: seenX, y: seenY, halfWidth, halfHeight, facing, ink };
  }

  #steer(state, { left = false, right = false }) {
    const wanted = (Number(right) - Number(left)) * RUN_SPEED * this.#unit;
    const gain = (state.ground ? RUN_GAIN : AIR_GAIN) * this.#unit * STEP;
    const [vx, vy] = state.velocity;
    if (wanted !== 0) state.facing = Math.sign(wanted);
    state.velocity = [
      vx < wanted ? Math.min(vx + gain, wanted) : Math.max(vx - gain, wanted),
      Math.max(vy - this.#gravity * STEP, -FALL_SPEED * this.#unit),
    ];
  }

  #jump(state, held) {
    const pressed = held && !state.jumpWasHeld;
    state.jumpWasHeld = held;
    state.sinceGround = state.ground ? 0 : state.sinceGround + STEP;
    state.sinceJumpKey = pressed ? 0 : state.sinceJumpKey + STEP;
    const [vx, vy] = state.velocity;
    if (state.sinceJumpKey <= KINDNESS && state.sinceGround <= KINDNESS) {
      const [gx, gy] = state.ground ?? [0, 0];
      const rise = Math.sqrt(2 * this.#gravity * JUMP_HEIGHT * this.#unit);
      state.velocity = [vx + gx, rise + Math.max(0, gy)];
      state.sinceGround = state.sinceJumpKey = 1;
      state.rising = true;
    } else if (state.rising && !held && vy > 0) {
      state.velocity = [vx, vy * CUT_SHORT];
      state.rising = false;
    }
  }
}
