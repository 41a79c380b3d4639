"""The examples: pygame without a screen, and Gymnasium's own check of an environment."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ["THUD_PROJECT"]) / "bindings/python/examples"))


def test_pygame_draws_what_falls(monkeypatch):
    import falling
    import pygame
    pygame.init()
    surface = pygame.Surface((falling.WIDTH, falling.HEIGHT))
    game = falling.Game()

    def pixel(slot):
        x, y = game.world.poses()[slot, :2]
        return tuple(surface.get_at((round(x * falling.PIXELS), round(falling.HEIGHT - y * falling.PIXELS))))[:3]

    before = [game.world.poses()[slot, 1] for slot in (1, 2)]
    game.world.step(30)
    game.draw(surface, 1.0)
    assert (pixel(1), pixel(2)) == (falling.BALL, falling.BOX)
    assert all(game.world.poses()[slot, 1] < height - 1 for slot, height in zip((1, 2), before))
    assert tuple(surface.get_at((5, falling.HEIGHT - 5)))[:3] == falling.GROUND
    monkeypatch.setattr(sys, "argv", ["falling.py", "--frames", "3"])
    falling.main()


def test_landing_is_an_environment():
    import gymnasium
    import landing
    from gymnasium.utils.env_checker import check_env
    check_env(landing.Landing())
    many = gymnasium.vector.SyncVectorEnv([landing.Landing] * 3)
    observations, _ = many.reset(seed=1)
    assert observations.shape == (3, 7)
    many.close()


def flight(seed, policy):
    import landing
    environment = landing.Landing()
    observation, _ = environment.reset(seed=seed)
    total, ended = 0.0, False
    while not ended:
        observation, reward, done, late, more = environment.step(policy(observation))
        total, ended = total + reward, done or late
    environment.close()
    return total, more["landed"], observation.tobytes()


def test_landing_can_be_flown_and_repeats_to_the_bit():
    import landing
    for seed in range(4):
        total, landed, _ = flight(seed, landing.pilot)
        assert landed and total > 100
        fallen, crashed, _ = flight(seed, lambda _: 0)
        assert not crashed and fallen < total
    assert flight(7, landing.pilot) == flight(7, landing.pilot)
