"""Boxes and balls in a window of pygame: a click drops one, Escape ends.

    falling.py [--frames N]    ends after so many pictures"""

import argparse
import itertools
import math

import pygame

import thud

WIDTH, HEIGHT, PIXELS = 960, 640, 32  # PIXELS: of a length
BALL, BOX, GROUND = (240, 160, 60), (90, 160, 230), (110, 120, 110)
STEPS_A_PICTURE_MAX = 4


def hills():
    """The points of the ground, as wide as the window."""
    return [(x, 1.2 + math.sin(0.5 * x)) for x in range(WIDTH // PIXELS + 1)]


class Game:
    def __init__(self):
        self.world = thud.World()
        self.world.body().terrain(hills())
        self.sizes = {}  # of each thing by slot: radius, or half width and half height
        self.next_is_ball = itertools.cycle((True, False))
        for number in range(24):
            self.drop((5 + number % 8 * 2.5, 8 + number // 8 * 2))

    def drop(self, place):
        body = self.world.body("dynamic", position=place)
        if next(self.next_is_ball):
            body.circle(0.5, restitution=0.4)
            self.sizes[body.slot] = (0.5,)
        else:
            body.obb(0.7, 0.4)
            self.sizes[body.slot] = (0.7, 0.4)

    def draw(self, surface, alpha):
        def on_screen(x, y):
            return x * PIXELS, HEIGHT - y * PIXELS

        surface.fill((24, 28, 34))
        ground = [on_screen(*point) for point in hills()]
        pygame.draw.polygon(surface, GROUND, [*ground, (WIDTH, HEIGHT), (0, HEIGHT)])
        poses = self.world.poses(alpha)
        for slot, size in self.sizes.items():
            x, y, c, s = poses[slot].tolist()
            if len(size) == 1:
                pygame.draw.circle(surface, BALL, on_screen(x, y), size[0] * PIXELS)
                continue
            corners = [(size[0] * i, size[1] * j) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
            pygame.draw.polygon(surface, BOX, [on_screen(x + c * i - s * j, y + s * i + c * j)
                                               for i, j in corners])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--frames", type=int, default=0)
    frames = parser.parse_args().frames
    pygame.init()
    surface = pygame.display.set_mode((WIDTH, HEIGHT))
    pygame.display.set_caption("thud")
    clock, game = pygame.time.Clock(), Game()
    for number in itertools.count(1):
        for event in pygame.event.get():
            if event.type == pygame.QUIT or event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
                return
            if event.type == pygame.MOUSEBUTTONDOWN:
                game.drop((event.pos[0] / PIXELS, (HEIGHT - event.pos[1]) / PIXELS))
        _, alpha = game.world.advance(clock.tick(60) / 1000, STEPS_A_PICTURE_MAX)
        game.draw(surface, alpha)
        pygame.display.flip()
        if number == frames:
            return


if __name__ == "__main__":
    main()
