"""Makes the level of the game "Platformer", assets/levels/adventure.tmj.

The level goes from left to right, and needs each ability of the character, in this order: to jump
over a pit, climb planks, drop through planks, walk on slopes, ride a lift across and one up, and
push a crate. Heights and distances follow from how far the character jumps: 3.2 m high and 7 m far.
The test tests/web/worker/platformer.test.mjs plays the level to the end and collects every coin.
Lengths are in metres, which are tiles."""

import math
import random

from tiled_map import BRICK, GRASS, STONE, Map

COLUMNS, ROWS = 206, 30
GROUND = 4  # the height of the plain

# The category bits by which the game knows platforms and sensors.
ONE_WAY, COIN, SPIKES, CHECKPOINT, GOAL = 2, 4, 8, 16, 32

PITS = ((22, 26), (80, 92), (112, 118))
COINS = ((7, 5), (8.5, 5), (11, 7), (14.8, 9), (16.2, 9), (24, 7.5),  # to the first pit
         (37, 7.5), (33.5, 9.9), (30, 12.2), (37.5, 12.3), (41, 13), (44, 5), (46, 5),  # the planks
         (59, 7.2), (62, 9.2), (66, 7.2), (72, 10.2), (76, 7.7),  # the hills
         (84, 6.8), (86, 7.6), (88, 6.8),  # the lift across
         (111, 9), (104.8, 11.2), (106.2, 11.2), (117.2, 12), (112.8, 14),  # the crate, the lift up
         (122, 17), (127, 19.2), (131, 19.7), (136, 17),  # the cliff
         (142, 17.6), (145, 18.4), (148, 17.6),  # the chasm
         (162, 12.4), (166, 9.2), (170, 6.6), (184, 7), (190.5, 7), (196, 8), (198, 9.6))


def adventure_cells():
    """The tiles by (column, row from below): stone for the plain, brick for what is built on it."""
    cells = {}

    def fill(x0, x1, y0, y1, tile):
        for x in range(x0, x1):
            for y in range(y0, y1):
                cells[x, y] = tile

    fill(0, COLUMNS, 0, GROUND, STONE)
    for x0, x1 in PITS:
        for x in range(x0, x1):
            for y in range(1, GROUND):
                del cells[x, y]
    for x in (0, COLUMNS - 1):
        fill(x, x + 1, GROUND, ROWS, STONE)
    for x0, x1, y0, y1 in ((10, 12, 4, 6), (14, 17, 7, 8),  # first steps
                           (40, 42, 4, 12), (48, 50, 7, 18),  # in between one must drop
                           (110, 112, 4, 8),  # too high without the crate
                           (118, 138, 4, 16), (152, 160, 4, 13),  # two cliffs
                           (195, 196, 4, 5), (196, 197, 4, 6), (197, 198, 4, 7), (198, 205, 4, 8)):
        fill(x0, x1, y0, y1, BRICK)
    return cells


def hills(turns):
    """A smooth line through these highest and lowest points, horizontal there, with a point for
    each metre."""
    points = [turns[0]]
    for (x0, y0), (x1, y1) in zip(turns, turns[1:]):
        for x in range(x0 + 1, x1 + 1):
            rise = 0.5 - 0.5 * math.cos(math.pi * (x - x0) / (x1 - x0))
            points.append((x, round(y0 + (y1 - y0) * rise, 3)))
    return points


def adventure():
    """Writes the level."""
    m = Map(COLUMNS, ROWS, title="Adventure", gravity_y=-20.0, camera_x=18.0, camera_y=10.0,
            camera_height=20.0, character=True,
            about="Collect the coins and reach the flag: over pits and planks, by lifts, with a "
                  "crate to stand on.")
    cells = adventure_cells()
    rng = random.Random(4)
    grass = {(x, y + 1): GRASS for (x, y), tile in cells.items()
             if tile == STONE and (x, y + 1) not in cells and y == GROUND - 1
             and rng.random() < 0.5}
    m.tile_layer("ground", cells)
    m.tile_layer("grass", grass, solid=False)
    slopes = m.object_layer("slopes")
    m.line(slopes, hills([(56, 4), (62, 8), (66, 6), (72, 9), (79, 4)]), name="hills")
    m.line(slopes, hills([(160, 13), (172, 4)]), name="way down")
    m.box(slopes, 97.5, 4.2, 1, 0.4, name="keeps the crate from the pit")
    planks = m.object_layer("planks", category=ONE_WAY)
    for x, y, width in ((37, 6.4, 3), (33.5, 8.8, 3), (30, 11, 2), (37.5, 11.2, 3), (45, 9.85, 6),
                        (105.5, 10, 3), (127, 18, 2), (131, 18.5, 2)):
        m.box(planks, x, y, width, 0.3)
    lifts = m.object_layer("lifts", body="kinematic", fixed_rotation=True, friction=0.9)
    for x, y, vx, vy in ((83, 3.8, 3, 0), (115, 7, 0, 3), (141, 14.8, 3, 0)):
        m.box(lifts, x, y, 3, 0.4, custom={"velocity_x": float(vx), "velocity_y": float(vy)})
    stops = m.object_layer("stops", sensor=True)  # where lifts turn back
    for x, y in ((115, 4.4), (115, 16.4), (151.8, 14.8)):
        m.box(stops, x, y, 0.4, 0.4)
    crates = m.object_layer("crates", body="dynamic", density=0.5)
    m.box(crates, 102, 4.7, 1.4, 1.4, name="to stand on", custom={"fixed_rotation": True})
    for x, y in ((175, 4.45), (175.95, 4.45), (175.5, 5.35)):
        m.box(crates, x, y, 0.9, 0.9, name="to run through", custom={"friction": 0.2})
    coins = m.object_layer("coins", sensor=True, category=COIN)
    for x, y in COINS:
        m.circle(coins, x, y, 0.35)
    spikes = m.object_layer("spikes", sensor=True, category=SPIKES)
    for x0, x1, y in [(x0, x1, 1) for x0, x1 in PITS] + [
            (125, 133, 16), (138, 152, 4), (183, 185, 4), (189, 192, 4)]:
        m.box(spikes, 0.5 * (x0 + x1), y + 0.25, x1 - x0, 0.5)
    checkpoints = m.object_layer("checkpoints", sensor=True, category=CHECKPOINT)
    for x, y in ((28, 4), (53, 4), (94.5, 4), (120.5, 16), (179, 4)):
        m.box(checkpoints, x, y + 1.2, 0.6, 2.4)
    m.box(m.object_layer("goal", sensor=True, category=GOAL), 202, 9.5, 0.8, 3)
    m.spawn(m.object_layer("places"), 3, 4.8)
    m.write("adventure")
