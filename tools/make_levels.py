#!/usr/bin/env python3
"""Makes the levels in assets/levels, which are maps of the Tiled editor, and the picture of their
tiles.

It needs Python 3 only, and gives the same files each time. assets/levels/README.md describes the
properties. Lengths are in metres, which are tiles, with y up."""

import csv
import random
import struct
import zlib

from adventure_level import adventure
from playground_level import playground
from tiled_map import ASSETS, BRICK, GRASS, ICE, LEVELS, STONE, TILE, Map


def tile_pixel(tile, x, y):
    """The colour of a pixel of a tile, as red, green, blue, alpha."""
    if tile == GRASS:
        blade = (x * 7 + 3) % 11 + 8
        return (92, 140, 70, 255) if TILE - y <= blade and x % 3 else (0, 0, 0, 0)
    edge = x == 0 or y == 0 or x == TILE - 1 or y == TILE - 1
    if tile == STONE:
        return (70, 76, 88, 255) if edge else (104, 112, 126, 255)
    if tile == ICE:
        return (150, 200, 225, 255) if edge else (190, 226, 242, 255)
    course = y // 8
    joint = y % 8 == 7 or (x + 8 * (course % 2)) % 16 == 15
    return (112, 62, 50, 255) if joint or edge else (166, 92, 70, 255)


def write_tile_picture():
    """Writes tiles.png, with its chunks made here: signature, header, one compressed block, end."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    rows = bytearray()
    for y in range(TILE):
        rows.append(0)
        for tile in (STONE, BRICK, ICE, GRASS):
            for x in range(TILE):
                rows.extend(tile_pixel(tile, x, y))
    header = struct.pack(">IIBBBBB", 4 * TILE, TILE, 8, 6, 0, 0, 0)
    (LEVELS / "tiles.png").write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9))
        + chunk(b"IEND", b""))


# ---- platform ----

def platform_cells(columns, rows):
    """The tiles by (column, row from below): stone ground with gaps, a wall at both ends, ledges of
    brick, stairs, and slides of ice."""
    cells = {}

    def fill(x0, x1, y0, y1, tile):
        for x in range(x0, x1):
            for y in range(y0, y1):
                cells[x, y] = tile

    for x0, x1 in ((0, 34), (38, 70), (75, 104), (109, columns)):  # ground between gaps
        fill(x0, x1, 1, 4, STONE)
    fill(0, columns, 0, 1, STONE)  # what falls into a gap lands here
    fill(0, 1, 1, rows, STONE)
    fill(columns - 1, columns, 1, rows, STONE)
    for step in range(8):  # stairs up to the right, and down again
        fill(20 + step, 21 + step, 4, 5 + step, BRICK)
        fill(60 - step, 61 - step, 4, 5 + step, BRICK)
        fill(96 + step, 97 + step, 4, 5 + step, BRICK)
    for x0, x1, y, tile in ((6, 16, 9, BRICK), (9, 22, 15, BRICK), (26, 36, 16, ICE),
                            (40, 50, 12, BRICK), (44, 58, 18, BRICK), (62, 74, 10, ICE),
                            (64, 80, 22, BRICK), (78, 90, 14, BRICK), (84, 98, 19, BRICK),
                            (106, 118, 12, ICE), (108, 122, 20, BRICK), (122, 134, 9, BRICK),
                            (126, 140, 16, BRICK), (4, 30, 25, BRICK), (36, 60, 26, ICE),
                            (88, 120, 27, BRICK), (126, 146, 24, BRICK)):
        fill(x0, x1, y, y + 1, tile)
    return cells


def platform():
    """Writes a platformer level for a character."""
    columns, rows = 160, 34
    m = Map(columns, rows, title="Platforms", gravity_y=-20.0, camera_x=36.0, camera_y=15.0,
            camera_height=30.0, character=True,
            about="Walk with the arrows and jump with Space: on stairs, planks and lifts, "
                  "among crates and balls.")
    cells = platform_cells(columns, rows)
    rng = random.Random(1)
    grass = {(x, y + 1): GRASS for (x, y), tile in cells.items()
             if tile != ICE and (x, y + 1) not in cells and y + 1 < rows and rng.random() < 0.35}
    m.tile_layer("ground", cells)
    m.tile_layer("grass", grass, solid=False)
    crates = m.object_layer("crates", body="dynamic", density=0.7)
    for x, base in ((11, 10), (15, 16), (45, 13), (53, 19), (72, 23), (84, 15), (91, 20),
                    (112, 13), (115, 21), (128, 10), (133, 17)):
        for row in range(4):
            for i in range(4 - row):
                m.box(crates, x + (i - 0.5 * (3 - row)) * 0.95, base + 0.45 + 0.9 * row, 0.9, 0.9)
    balls = m.object_layer("balls", body="dynamic", restitution=0.6)
    for i in range(40):
        m.circle(balls, 3 + 3.6 * i, 30.6 + rng.random() * 1.4, rng.uniform(0.25, 0.55),
                 custom={"velocity_x": round(rng.uniform(-4, 4), 2)})
    figures = m.object_layer("figures", body="dynamic", fixed_rotation=True, friction=0.1)
    for i in range(24):
        m.box(figures, 5 + 6 * i, 29, 0.7, 1.6,
              custom={"velocity_x": round(rng.choice((-1, 1)) * rng.uniform(3, 8), 2)})
    planks = m.object_layer("planks", category=2)  # passed from below
    for x, y in ((3.5, 7), (7, 13), (24, 13.3), (31, 6.5), (31, 9), (31, 11.5), (31, 14), (42, 15),
                 (42, 17.3), (65.5, 13.5), (62, 16), (60.5, 18.4), (62, 20.7), (76, 12.5),
                 (82, 17.2), (124, 12.3), (124.3, 14.7)):
        m.box(planks, x, y, 3, 0.3)
    lifts = m.object_layer("lifts", body="kinematic", fixed_rotation=True, friction=0.9)
    for x, y, width, vx, vy in ((38, 8, 3, 0, 2.5), (53, 12.8, 3, 2.5, 0), (72.5, 6, 3, 2.5, 0),
                                (104.5, 8, 2.4, 0, 2.5), (103, 21.8, 3, 3, 0), (150, 8, 3, 0, 3)):
        m.box(lifts, x, y, width, 0.4, custom={"velocity_x": float(vx), "velocity_y": float(vy)})
    stops = m.object_layer("stops", sensor=True)
    for x, y in ((38, 18), (61.8, 12.8), (66, 6), (80, 6), (104.5, 19.5), (98.4, 21.8),
                 (107.6, 21.8), (150, 26)):
        m.box(stops, x, y, 0.4, 0.4)
    m.spawn(m.object_layer("places"), 31, 18)
    m.write("platform")


# ---- quarry ----

def height_at(points, x):
    """The height of a line at x, which must be on it."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    raise ValueError(f"{x} is beside the ground")


def clear_height(points, x, reach):
    """The largest height of a line between x - reach and x + reach."""
    inside = [y for px, y in points if x - reach <= px <= x + reach]
    return max([height_at(points, x - reach), height_at(points, x + reach)] + inside)


def quarry():
    """Writes a quarry: a terrain of steps, with 700 stones of many sizes."""
    m = Map(140, 60, title="Quarry", camera_x=70.0, camera_y=24.0, camera_height=52.0,
            about="Rubble of every size and weight slides down the benches of a quarry.")
    rng = random.Random(2)
    benches = [(0, 40), (6, 41), (14, 40), (16, 33), (24, 32), (27, 25), (36, 24), (39, 16),
               (48, 15), (52, 8), (60, 5), (70, 4), (80, 5.5), (88, 8), (91, 15), (101, 17),
               (104, 25), (113, 26), (116, 34), (125, 35), (127, 42), (134, 43), (140, 41)]
    points = [benches[0]]
    for (x0, y0), (x1, y1) in zip(benches, benches[1:]):
        cuts = max(1, int((x1 - x0) / 1.5))
        for i in range(1, cuts + 1):
            t = i / cuts
            rough = rng.uniform(-0.25, 0.25) if i < cuts else 0
            points.append((round(x0 + (x1 - x0) * t, 2), round(y0 + (y1 - y0) * t + rough, 2)))
    ground = m.object_layer("ground", friction=0.7)
    m.line(ground, points[::-1], name="rock")  # drawn from right to left, as one may
    m.box(ground, -0.5, 80, 1, 100, name="left wall")
    m.box(ground, 140.5, 80, 1, 100, name="right wall")
    stones = m.object_layer("stones", body="dynamic", friction=0.6)
    top = {}
    for i in range(700):
        # One in twelve is a boulder; one in nine is of heavy ore.
        size = rng.uniform(1.0, 1.8) if i % 12 == 0 else rng.uniform(0.25, 0.8)
        x = rng.uniform(2.5, 137.5)
        reach = 1.5 * size
        column = range(int(x - reach), int(x + reach) + 1)
        y = max([clear_height(points, x, min(reach, 2.4)) + 0.5] + [top.get(c, 0) for c in column])
        y += reach
        for c in column:
            top[c] = y + reach
        custom = {"density": 6.0} if i % 9 == 0 else {}
        if i % 3 == 0:
            m.circle(stones, x, y, size, custom=custom)
        else:
            m.box(stones, x, y, 2 * size * rng.uniform(0.6, 1), 2 * size * rng.uniform(0.6, 1),
                  rng.uniform(-180, 180), custom=custom)
    m.spawn(m.object_layer("places"), 70, 50)
    m.write("quarry")


# ---- towers ----

def towers():
    """Writes five towers of blocks and planks, and a heavy ball that flies into them."""
    m = Map(120, 50, title="Towers and a wrecking ball", camera_x=62.0, camera_y=16.0,
            camera_height=40.0,
            about="A heavy ball flies into towers of blocks and planks, one after the other.")
    ground = m.object_layer("ground")
    m.box(ground, 60, 1, 120, 2, name="ground")
    blocks = m.object_layer("blocks", body="dynamic")
    for tower, (x, storeys) in enumerate(((34, 7), (48, 10), (62, 8), (78, 12), (96, 9))):
        y = 2.0
        for storey in range(storeys):
            width = 5.0 if tower % 2 == 0 else 3.6
            for side in (-1, 0, 1):
                m.box(blocks, x + side * (width / 2 - 0.4), y + 0.9, 0.8, 1.8)
            m.box(blocks, x, y + 2.0, width, 0.4, custom={"density": 0.6}, name="plank")
            y += 2.2
        for i in range(3):
            m.box(blocks, x + (i - 1) * 1.1, y + 0.5, 1, 1)
        m.circle(blocks, x, y + 1.6, 0.6, custom={"restitution": 0.4})
    ball = m.object_layer("wrecking ball", body="dynamic", density=20.0)
    m.circle(ball, 8, 9, 2.5, name="wrecking ball",
             custom={"velocity_x": 32.0, "velocity_y": 6.0})
    m.spawn(m.object_layer("places"), 20, 25)
    m.write("towers")


# ---- mountain ----

def mountain():
    """Writes a terrain from measured heights, with wheels and boulders."""
    with open(ASSETS / "terrain" / "jacksboro_300.csv", encoding="utf-8") as file:
        profile = [(float(row["east_m"]), float(row["elevation_m"]))
                   for row in csv.DictReader(file)]
    # The distance between samples, 74.4 m, becomes 2 m; heights are exaggerated 2.2-fold.
    across, up = 2 / 74.4, 2.2 * 2 / 74.4
    lowest = min(y for _, y in profile)
    points = [(round(x * across + 2, 3), round((y - lowest) * up + 4, 3)) for x, y in profile]
    right = points[-1][0]
    m = Map(int(right) + 3, 72, tile=16, title="Mountain drive", camera_x=230.0, camera_y=36.0,
            camera_height=80.0,
            about="Wheels and boulders roll over a real mountain ridge in Tennessee.")
    ground = m.object_layer("ground", friction=0.9)
    m.line(ground, points, name="Jacksboro fault, row 300")
    m.box(ground, 1.5, 40, 1, 80, name="west wall")
    m.box(ground, right + 0.5, 40, 1, 80, name="east wall")
    rng = random.Random(3)
    wheels = m.object_layer("wheels", body="dynamic", friction=1.0, restitution=0.1)
    boulders = m.object_layer("boulders", body="dynamic", density=2.5)
    free = 5.0  # left of it the ground is taken
    while free < right - 8:
        radius = rng.uniform(0.4, 1.4)
        x = free + 1.3 * radius  # half the diagonal of a boulder that is a box
        y = clear_height(points, x, radius) + radius + 0.3
        if rng.random() < 0.5:
            speed = round(rng.choice((-1, 1)) * rng.uniform(5, 15), 2)
            m.circle(wheels, x, y, radius, custom={
                "velocity_x": speed, "angular_velocity": round(-speed / radius, 2)})
        elif rng.random() < 0.5:
            m.circle(boulders, x, y, radius)
        else:
            m.box(boulders, x, y + 0.5 * radius, 2 * radius, 1.6 * radius, rng.uniform(-90, 90))
        free = x + 1.3 * radius + rng.uniform(0.2, 1.5)
    m.spawn(m.object_layer("places"), 230, 70)
    m.write("mountain")


if __name__ == "__main__":
    LEVELS.mkdir(parents=True, exist_ok=True)
    write_tile_picture()
    platform()
    quarry()
    towers()
    mountain()
    adventure()
    playground()
