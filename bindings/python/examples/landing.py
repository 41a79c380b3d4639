"""An environment for Gymnasium: a craft with two engines lands softly and upright on a line of ground.

    environment = Landing()
    observation, _ = environment.reset(seed=1)

Actions: 0 none, 1 the left engine, 2 the right one, 3 both. An observation is x, y above the ground,
velocity x and y, cosine and sine of the angle, and the angular velocity, in lengths, seconds and radians.
A step lasts a tenth of a second. The reward is the gain in closeness to rest on the pad, less the fuel;
landing gives 100, a crash -100. The same seed and actions give the same bits on every machine."""

import math

import gymnasium
import numpy

import thud

STEPS_AN_ACTION = 6  # of 1/60 s
SECONDS_MAX = 60
HALF_WIDTH, HALF_HEIGHT = 1.0, 0.5
MASS = 4 * HALF_WIDTH * HALF_HEIGHT  # by the density 1
THRUST = 0.9 * 10 * MASS  # of one engine, by the gravity of 10; mass * length / s^2
FUEL = 0.03  # reward that an engine takes in an action
SIDE_MAX, HEIGHT_MAX = 30.0, 40.0
SPEED_OF_CRASH, TILT_OF_CRASH = 2.0, 0.3  # lengths/s; rad


class Landing(gymnasium.Env):
    metadata = {"render_modes": []}

    def __init__(self):
        self.action_space = gymnasium.spaces.Discrete(4)
        self.observation_space = gymnasium.spaces.Box(-numpy.inf, numpy.inf, (7,), numpy.float32)
        self.world = self.craft = None
        self.time, self.potential = 0.0, 0.0

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.close()
        self.world = thud.World()
        self.world.body().terrain()
        self.craft = self.world.body(
            "dynamic", position=(self.np_random.uniform(-8, 8), self.np_random.uniform(12, 18)),
            angle=self.np_random.uniform(-0.3, 0.3), velocity=(self.np_random.uniform(-2, 2), 0))
        self.craft.obb(HALF_WIDTH, HALF_HEIGHT, friction=0.9)
        self.time = 0.0
        observation = self._observe()
        self.potential = self._closeness(observation)
        return observation, {}

    def step(self, action):
        state = self.craft.state
        engines = [side for side, bit in ((-1, 1), (1, 2)) if action & bit]
        touched, speed = False, 0.0
        for _ in range(STEPS_AN_ACTION):
            if engines:
                # Up along the craft; an engine at its end turns it, too.
                self.craft.apply_force([part * THRUST * len(engines)
                                        for part in (-state.sine, state.cosine)])
                self.craft.apply_torque(0.25 * THRUST * HALF_WIDTH * sum(engines))
            speed = -self.craft.velocity.y
            self.world.step()
            state = self.craft.state
            if len(self.world.events().begin):
                touched = True
                break
        self.time += STEPS_AN_ACTION / 60
        observation = self._observe()
        closeness = self._closeness(observation)
        reward = closeness - self.potential - FUEL * len(engines)
        self.potential = closeness
        lost = abs(observation[0]) > SIDE_MAX or observation[1] > HEIGHT_MAX
        landed = touched and speed < SPEED_OF_CRASH and abs(state.angle) < TILT_OF_CRASH
        if touched or lost:
            reward += 100 if landed else -100
        return observation, float(reward), bool(touched or lost), self.time >= SECONDS_MAX, \
            {"landed": landed}

    def close(self):
        if self.world:
            self.world.close()
            self.world = None

    def _observe(self):
        state = self.craft.state
        return numpy.array([state.position.x, state.position.y - HALF_HEIGHT, *state.velocity, state.cosine,
                            state.sine, state.angular_velocity], numpy.float32)

    @staticmethod
    def _closeness(observation):
        x, y, vx, vy, _, sine, _ = (float(value) for value in observation)
        return -(math.hypot(x, y) + math.hypot(vx, vy) + 5 * abs(sine))


def pilot(observation):
    """A hand-made policy that lands: each engine is on where height or tilt ask for it."""
    x, y, vx, vy, _, sine, spin = observation
    tilt = numpy.clip(0.04 * x + 0.12 * vx, -0.25, 0.25)
    turn = (tilt - sine) * 4 - 2 * spin
    lift = vy < -(0.6 + 0.25 * y)
    return int(lift or turn < -0.3) | 2 * int(lift or turn > 0.3)
