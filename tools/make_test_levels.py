#!/usr/bin/env python3
"""Makes the maps in tests/levels/maps, each as JSON and as XML. Each uses a part of Tiled's file
formats. tests/levels/test_level_formats.c and tests/web/package/level-formats.test.mjs read them.

It gives the same files each time. Lengths are in pixels, with y down."""

import base64
import ctypes
import gzip
import json
import struct
import zlib
from pathlib import Path

from tiled_map import properties
from tiled_xml import xml_of

FOLDER = Path(__file__).resolve().parent.parent / "tests" / "levels" / "maps"
TILE = 32
FLIP_X, FLIP_Y, TURN = 1 << 31, 1 << 30, 1 << 29
# Tile numbers of the tileset ground_tiles, as cells have them.
STONE, BALL, SLOPE, HALF, ANGLE, LEAN, OPEN, ICE = range(1, 9)


def zstd(data):
    """Compresses bytes by the system's libzstd."""
    library = ctypes.CDLL("libzstd.so.1")
    library.ZSTD_compressBound.restype = library.ZSTD_compress.restype = ctypes.c_size_t
    library.ZSTD_compressBound.argtypes = [ctypes.c_size_t]
    library.ZSTD_compress.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_char_p,
                                      ctypes.c_size_t, ctypes.c_int]
    out = ctypes.create_string_buffer(library.ZSTD_compressBound(len(data)))
    size = library.ZSTD_compress(out, len(out), data, len(data), 19)
    return out.raw[:size]


PACKINGS = {"": lambda data: data, "zlib": lambda data: zlib.compress(data, 9),
            "gzip": lambda data: gzip.compress(data, 9, mtime=0), "zstd": zstd}


def packed(cells, packing):
    """Tile numbers as base64, compressed by one of PACKINGS."""
    data = struct.pack(f"<{len(cells)}I", *cells)
    return base64.b64encode(PACKINGS[packing](data)).decode("ascii")


class Objects:
    """A list of objects with ids from 1 on."""

    def __init__(self):
        self.list = []

    def add(self, x, y, **rest):
        custom = rest.pop("custom", {})
        entry = {"id": len(self.list) + 1, "x": x, "y": y, **rest}
        if custom:
            entry["properties"] = properties(**custom)
        self.list.append(entry)


def shape(x, y, **rest):
    """A collision shape of a tile."""
    return {"id": 1, "x": x, "y": y, **rest}


def tile(number, *objects, **custom):
    """The entry of a tile with collision shapes and custom properties."""
    entry = {"id": number - 1}
    if objects:
        entry["objectgroup"] = {"type": "objectgroup", "draworder": "index",
                                "objects": [{**one, "id": i + 1} for i, one in enumerate(objects)]}
    if custom:
        entry["properties"] = properties(**custom)
    return entry


def points(*pairs):
    return [{"x": x, "y": y} for x, y in pairs]


def ground_tiles():
    """A tileset with a collision shape of each kind that the reader supports."""
    return {"type": "tileset", "name": "ground", "tilewidth": TILE, "tileheight": TILE,
            "tilecount": 8, "columns": 8, "tiles": [
                tile(STONE, shape(0, 0, width=TILE, height=TILE)),
                tile(BALL, shape(4, 6, width=20, height=20, ellipse=True)),
                tile(SLOPE, shape(0, TILE, polygon=points((0, 0), (TILE, -TILE), (TILE, 0)))),
                tile(HALF, shape(0, 0, width=TILE, height=10), shape(6, 18, width=9, height=14)),
                tile(ANGLE, shape(0, 0, polygon=points((0, 0), (12, 0), (12, 20), (TILE, 20),
                                                       (TILE, TILE), (0, TILE)))),
                tile(LEAN, shape(9, 3, width=18, height=6, rotation=37)),
                tile(ICE, solid=True, friction=0.02)]}


def things():
    """A tileset of pictures with different sizes, for tile objects."""
    return {"type": "tileset", "name": "things", "tilewidth": 96, "tileheight": 80,
            "tilecount": 4, "columns": 0, "tiles": [
                {"id": 0, "image": "crate.png", "imagewidth": 40, "imageheight": 24},
                {"id": 3, "image": "barrel.png", "imagewidth": 32, "imageheight": 32,
                 **tile(4, shape(0, 0, width=32, height=32, ellipse=True), density=3.0)},
                {"id": 5, "image": "sign.png", "imagewidth": 96, "imageheight": 80,
                 **tile(6, shape(0, 0, width=96, height=16), shape(40, 16, width=16, height=64))}]}


def map_of(layers, columns=20, rows=15, tilesets=(), infinite=False, **custom):
    return {"type": "map", "version": "1.10", "orientation": "orthogonal", "width": columns,
            "height": rows, "tilewidth": TILE, "tileheight": TILE, "infinite": infinite,
            "tilesets": list(tilesets), "layers": layers, "properties": properties(**custom)}


def object_layer(objects, **custom):
    return {"type": "objectgroup", "id": 2, "name": "things", "objects": objects.list,
            "properties": properties(**custom)}


def tile_layer(cells, columns, rows, packing=None, **custom):
    layer = {"type": "tilelayer", "id": 1, "name": "ground", "width": columns, "height": rows,
             "properties": properties(**custom)}
    if packing is None:
        return {**layer, "data": cells}
    return {**layer, "encoding": "base64", "compression": packing, "data": packed(cells, packing)}


def balls(count, across, top=40):
    """Circles and turned boxes that fall on the level, so that its shapes affect the result."""
    objects = Objects()
    for i in range(count):
        side = 14 + 2 * (i % 3)
        objects.add(across * (i + 0.5) / count, top + 7 * (i % 5), width=side, height=side,
                    **({"ellipse": True} if i % 2 else {"rotation": 11 * i}),
                    custom={"body": "dynamic"})
    return objects


def shapes():
    """Each collision shape in all eight orientations of a tile."""
    columns, rows = 20, 15
    cells = [0] * (columns * rows)
    for i in range(columns):
        cells[(rows - 1) * columns + i] = STONE
    for number in (BALL, HALF, ANGLE, LEAN, ICE, OPEN):
        for flip in range(8):
            row, column = 3 + number % 5 * 2, 1 + 2 * flip + number % 2
            cells[row * columns + column] = number | flip << 29
    for column, flip in ((6, 0), (9, FLIP_X)):
        cells[(rows - 2) * columns + column] = SLOPE | flip
    return map_of([tile_layer(cells, columns, rows), object_layer(balls(40, 640, 8))],
                  columns, rows, [{"firstgid": 1, "source": "tiles/ground.tsx"}])


def hills():
    """Polygons that become ground lines or boxes, and a polyline."""
    objects = balls(30, 640)
    objects.add(0, 480, polygon=points((0, 0), (0, -60), (90, -90), (200, -40), (320, -70),
                                       (320, 0)))
    objects.add(640, 490, polygon=points((0, 0), (-320, 0), (-320, -80), (-100, -30), (0, -120)))
    objects.add(200, 200, rotation=20, polygon=points((0, 0), (64, 0), (64, 24), (0, 24)))
    objects.add(420, 220, polygon=points((0, 0), (48, 36), (36, 52), (-12, 16)))
    objects.add(100, 260, polygon=points((0, 0), (60, 0), (60, 60), (40, 60), (40, 20), (20, 20),
                                         (20, 60), (0, 60)))
    objects.add(320, 60, polygon=points((0, 0), (40, 0), (40, 20), (20, 20), (20, 60), (0, 60)),
                rotation=15, custom={"body": "dynamic", "friction": "0.9"})
    objects.add(520, 300, polyline=points((0, 0), (-60, 20), (-110, 0)))
    return map_of([object_layer(objects)])


def template(content, source, **object_fields):
    return {"type": "template", "tileset": {"firstgid": 1, "source": source},
            "object": {**object_fields, **content}}


def props():
    """Tile objects: turned, flipped, scaled, and from templates."""
    first, more = 1, 100
    crate, barrel, sign = more, more + 3, more + 5
    objects = balls(12, 640)
    dynamic = {"body": "dynamic"}
    objects.add(60, 120, gid=crate, width=40, height=24, custom=dynamic)
    objects.add(160, 120, gid=crate, width=60, height=18, rotation=30, custom={"bodyType": "dynamic"})
    objects.add(260, 120, gid=barrel, width=32, height=32, custom=dynamic)
    objects.add(340, 120, gid=barrel, width=48, height=48, rotation=-75, custom=dynamic)
    objects.add(420, 160, gid=sign | FLIP_Y, width=96, height=80, rotation=10, custom=dynamic)
    objects.add(100, 300, gid=sign, width=48, height=80)
    objects.add(300, 300, gid=first + SLOPE - 1 | FLIP_X, width=64, height=32, rotation=0,
                custom={"solid": False})
    objects.add(420, 330, gid=first + LEAN - 1 | FLIP_X, width=64, height=64, rotation=45)
    objects.add(200, 400, gid=crate, width=40, height=24)
    objects.add(60, 40, template="templates/crate.tx")
    objects.add(120, 40, template="templates/crate.tx", rotation=45, custom={"density": 4})
    objects.add(180, 40, template="templates/crate.tx", gid=barrel, width=24, height=24)
    objects.add(240, 40, template="templates/plank.tj")
    cells = [0] * (20 * 14) + [first + STONE - 1] * 20
    return map_of([tile_layer(cells, 20, 15), object_layer(objects)], tilesets=[
        {"firstgid": first, "source": "tiles/ground.tsx"},
        {"firstgid": more, "source": "tiles/things.tsj"}])


def polygons():
    """Polygons that shapes approximate: at rest and moving, turned, of a tile, heavier, one that is
    ground all the same, one of edges that cross, and one without the property."""
    objects = balls(12, 640)
    star = points((0, -40), (12, -12), (40, 0), (12, 12), (0, 40), (-12, 12), (-40, 0), (-12, -12))
    wedge = points((0, 0), (70, -20), (50, 30), (10, 24))
    some = {"approximate": 5}
    moving = {"approximate": 4, "body": "dynamic"}
    objects.add(120, 330, polygon=star, custom=some)
    objects.add(300, 300, polygon=star, rotation=30, custom={"approximate": 12})
    objects.add(200, 120, polygon=wedge, custom=moving)
    objects.add(330, 140, polygon=wedge, rotation=-70, custom={**moving, "density": 3})
    objects.add(460, 100, polygon=star, rotation=10, custom=moving)
    objects.add(420, 330, gid=SLOPE | FLIP_X, width=64, height=48, rotation=45,
                custom={"approximate": "3"})
    objects.add(0, 0, polygon=points((0, 440), (300, 460), (640, 430), (640, 480), (0, 480)),
                custom=some)
    objects.add(520, 300, polygon=points((0, 0), (60, 60), (60, 0), (0, 50)), custom=some)
    objects.add(560, 200, polygon=wedge, custom={"approximate": 0})
    return map_of([object_layer(objects)], tilesets=[{"firstgid": 1, "source": "tiles/ground.tsx"}])


def landscape(columns, rows):
    """Cells of which some rows compress well and others badly."""
    cells = [0] * (columns * rows)
    for i in range(columns):
        for j in range(rows - 2 - i * 7 % 3, rows):
            cells[j * columns + i] = (STONE, ICE, STONE | FLIP_X)[i * i % 3]
    return cells


def packed_map(packing):
    columns, rows = 24, 15
    layer = tile_layer(landscape(columns, rows), columns, rows, packing)
    return map_of([layer, object_layer(balls(20, 768))], columns, rows,
                  [{"firstgid": 1, "source": "tiles/ground.tsx"}])


def infinite_map():
    """An infinite map: chunks on both sides of the origin, an empty one below the others, and
    slopes."""
    side, chunks = 8, []
    for x, y in ((-8, 8), (0, 8), (8, 0), (8, 8), (0, 16)):
        cells = [0] * (side * side)
        if y == 8:
            for i in range(side):
                cells[5 * side + i] = SLOPE if i == 2 else 0
                cells[6 * side + i] = cells[7 * side + i] = STONE
        elif y == 0:
            cells[7 * side + 3] = HALF | TURN
        chunks.append({"x": x, "y": y, "width": side, "height": side, "data": packed(cells, "zlib")})
    layer = {"type": "tilelayer", "id": 1, "name": "ground", "width": 24, "height": 24,
             "startx": -8, "starty": 0, "encoding": "base64", "compression": "zlib",
             "chunks": chunks, "offsetx": 3.5}
    empty = {"type": "tilelayer", "id": 3, "name": "sky", "width": 24, "height": 24, "chunks": []}
    return map_of([layer, empty, object_layer(balls(16, 256))], 20, 15,
                  [{"firstgid": 1, "source": "tiles/ground.tsx"}], infinite=True)


def unmarked():
    """A map without any property or shape that says what collides, with tiles that are larger than
    cells, offset, or drawn as large as cells."""
    big = {"type": "tileset", "firstgid": 1, "name": "big", "tilewidth": 48, "tileheight": 40,
           "tilecount": 4, "columns": 4, "tileoffset": {"x": 5, "y": -3}}
    fitted = {"type": "tileset", "firstgid": 10, "name": "fitted", "tilewidth": 16,
              "tileheight": 16, "tilecount": 4, "columns": 4, "tilerendersize": "grid"}
    cells = [0] * 300
    cells[5 * 20 + 4] = 1
    cells[5 * 20 + 9] = 2 | TURN
    cells[7 * 20 + 12] = 10
    objects = Objects()
    objects.add(64, 64, gid=1, width=48, height=40)
    return map_of([tile_layer(cells, 20, 15), object_layer(objects)],
                  tilesets=[big, fitted])


def wrong():
    """An object of each kind that cannot be modelled, and a box that can."""
    objects = Objects()
    objects.add(0, 0, width=TILE, height=TILE)
    objects.add(0, 0, polygon=points((0, 0), (40, 60), (80, 0), (40, 20)))
    objects.add(0, 0, polygon=points((0, 0), (40, -30), (80, 0)))
    objects.add(0, 0, width=40, height=30, ellipse=True)
    objects.add(0, 0, width=40, height=30, text={"text": "a < b"})
    objects.add(0, 0, gid=77, width=40, height=30)
    objects.add(0, 0, template="templates/missing.tx")
    objects.add(0, 0, template="../../etc/passwd")
    objects.add(0, 0, template="/etc/passwd")
    objects.add(0, 0, gid=HALF, width=64, height=32)
    objects.add(0, 0, gid=BALL, width=64, height=32)
    objects.add(0, 0, gid=LEAN, width=64, height=32)
    objects.add(0, 0, capsule=True, width=64, height=32)
    cells = [0] * 300
    cells[45] = SLOPE  # in the air
    cells[46] = 99
    return map_of([tile_layer(cells, 20, 15), object_layer(objects)], tilesets=[
        {"firstgid": 1, "source": "tiles/ground.tsx"},
        {"firstgid": 50, "source": "tiles/missing.tsx"}])


def far():
    """Objects and tiles that are too far away or too large for the engine, each by one of its
    ranges, and two boxes that are not. A unit is a thousandth of a pixel."""
    objects = Objects()
    objects.add(0, 0, width=10, height=10)
    objects.add(999900, 0, width=10, height=10, custom={"body": "dynamic"})
    objects.add(2e6, 0, width=10, height=10)
    objects.add(0, 0, width=40, height=10)
    objects.add(0, 0, polygon=points((20, 0), (24, 0), (24, 8), (22, 8), (22, 4), (20, 4)))
    objects.add(0, 0, polyline=points((0, 0), (2e6, 0)))
    objects.add(0, -2e6, polyline=points((0, 0), (40, 0)))
    objects.add(0, 3e6, point=True, type="spawn")
    objects.add(2e6, 0, gid=STONE, width=10, height=10)
    joint(objects, "distance", 0, 0, 1, 2, polyline=points((0, 0), (1500, 0)))
    joint(objects, "hinge", 1000500, 0, b=2)
    stone = {**tile_layer([STONE], 1, 1), "offsetx": 2e6}
    return map_of([object_layer(objects), stone], pixels_per_unit=0.001, length_scale=1.5,
                  tilesets=[{"firstgid": 1, "source": "tiles/ground.tsx"}])


def joint(objects, kind, x, y, a=None, b=None, **rest):
    """Adds a joint between two objects, by their ids; returns the id of the joint's object."""
    custom = rest.pop("custom", {})
    shape = {} if {"polyline", "width"} & rest.keys() else {"point": True}
    objects.add(x, y, type=kind, **shape, **rest, custom=custom)
    refers = [{"name": name, "type": "object", "value": value}
              for name, value in (("a", a), ("b", b)) if value is not None]
    objects.list[-1]["properties"] = refers + objects.list[-1].get("properties", [])
    return len(objects.list)


def row(objects, y, count=2, **rest):
    """Adds boxes beside each other from x = 40 on, and returns their ids."""
    for i in range(count):
        objects.add(40 + 50 * i, y, width=30, height=16, **rest, custom={"body": "dynamic"})
    return range(len(objects.list) - count + 1, len(objects.list) + 1)


def joints():
    """Each kind of joint, with the world, static bodies and dynamic bodies, in each form in which a
    joint can be drawn."""
    objects = Objects()
    objects.add(0, 460, width=640, height=20)
    ground = 1
    first, second = row(objects, 40)
    joint(objects, "hinge", 40, 48, b=first)
    joint(objects, "hinge", 80, 48, first, second, custom={
        "turn_lower": -0.5, "turn_upper": 0.5, "turn_frequency": 3.0, "turn_target": 0.25})
    first, second = row(objects, 90, rotation=20)
    joint(objects, "weld", 76, 105, first, second)
    joint(objects, "slider", 40, 100, b=first, width=20, height=8, rotation=60, custom={
        "along_lower": -2.0, "along_motor_speed": -1.0, "along_motor_force": "30"})
    first, second, third = row(objects, 150, 3)
    joint(objects, "distance", 55, 120, b=first, polyline=points((0, 0), (0, 30)))
    joint(objects, "distance", 70, 158, first, second, polyline=points((0, 0), (20, 0)),
          custom={"along_frequency": 4.0, "along_damping": 0.1})
    joint(objects, "distance", 105, 158, second, third, rotation=-3,
          polyline=points((0, 0), (50, 3)), custom={"along_lower": 0.0})
    first, second = row(objects, 200)
    joint(objects, "target", 60, 208, b=first, custom={
        "along_frequency": 5.0, "across_frequency": 5.0, "along_spring_force": 400.0,
        "across_spring_force": 400.0, "turn_motor_force": 2.0})
    joint(objects, "filter", 0, 0, first, second)
    objects.add(300, 380, width=120, height=24, custom={"body": "dynamic"})
    chassis = len(objects.list)
    for x in (310, 410):
        objects.add(x - 16, 400, width=32, height=32, ellipse=True,
                    custom={"body": "dynamic", "friction": 1.0})
        joint(objects, "wheel", x, 416, chassis, len(objects.list),
              polyline=points((0, 0), (0, -30)), custom={
                  "along_frequency": 4.0, "along_lower": -0.3, "along_upper": 0.3,
                  "turn_motor_speed": -12.0, "turn_motor_force": 8.0})
    objects.add(500, 200, width=90, height=12, custom={"body": "dynamic"})
    plank = len(objects.list)
    later = plank + 3
    joint(objects, "hinge", 505, 206, later, plank, custom={
        "break_torque": 500.0, "collide_connected": True})
    joint(objects, "weld", 590, 206, b=plank, custom={
        "turn_frequency": 2.0, "across_frequency": 3.0, "break_force": 60.0})
    objects.add(490, 180, width=20, height=20, custom={"body": "dynamic"})
    joint(objects, "hinge", 500, 190, ground, later)
    axles = []
    for x, radius, speed in ((420, 16, 2.0), (452, 14, 0.0), (500, 10, 0.0)):
        objects.add(x - radius, 100, width=2 * radius, height=2 * radius, ellipse=True,
                    custom={"body": "dynamic"})
        axles.append(joint(objects, "hinge", x, 100 + radius, b=len(objects.list), custom={
            "turn_motor_speed": speed, "turn_motor_force": 5.0 * speed}))
    joint(objects, "gear", 430, 120, axles[0], axles[1], custom={"ratio": 0.875})
    joint(objects, "gear", 0, 0, axles[1], axles[2], polyline=points((9, 0), (19, 0)),
          custom={"ratio": -0.5})
    return map_of([object_layer(objects, turn_damping=0.9)])


def loose():
    """A joint with each mistake that the reader reports, and a hinge without one."""
    objects = Objects()
    objects.add(0, 460, width=640, height=20)
    objects.add(100, 100, width=60, height=20, custom={"body": "dynamic"})
    objects.add(200, 100, width=60, height=20, custom={"body": "dynamic"})
    joint(objects, "hinge", 110, 110, b=2)
    joint(objects, "hinge", 110, 110)
    joint(objects, "hinge", 110, 110, 2, 2)
    joint(objects, "hinge", 110, 110, 99, 98)
    joint(objects, "hinge", 110, 110, 2, "three")
    joint(objects, "wheel", 110, 110, 2, 1)
    joint(objects, "weld", 110, 110, b=1)
    joint(objects, "filter", 110, 110, b=2)
    joint(objects, "distance", 110, 110, 2, 3)
    joint(objects, "distance", 110, 110, 2, 3, polyline=points((0, 0), (5, 5), (9, 9)))
    joint(objects, "distance", 110, 110, 2, 3, polyline=points((4, 4), (4, 4)))
    joint(objects, "distance", 110, 110, 2, 3, polyline=points((0, 0), (32, 0)),
          custom={"along_lower": 2.0})
    joint(objects, "hinge", 9e8, 110, 2, 3)
    joint(objects, "hinge", 110, 110, 2, 3, custom={
        "turn_lower": 4.0, "turn_damping": "much", "break_force": -1.0, "along_target": 1.0})
    joint(objects, "slider", 110, 110, 2, 3, custom={"along_lower": 1.0, "along_upper": -1.0})
    joint(objects, "gear", 0, 0, 4, 1)
    joint(objects, "gear", 0, 0, 4, custom={"ratio": 0.0})
    objects.add(300, 100, width=20, height=20, ellipse=True, type="wheel",
                custom={"body": "dynamic"})
    other = joint(objects, "slider", 300, 100, 1, 2)
    joint(objects, "gear", 0, 0, 4, other)
    joint(objects, "gear", 0, 0, other, joint(objects, "weld", 110, 110, 2, 3))
    return map_of([object_layer(objects)])


def write_json(name, content):
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content) + "\n", encoding="utf-8")


def write_xml(name, content):
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(xml_of(content), encoding="utf-8")


def main():
    maps = {"shapes": shapes(), "hills": hills(), "props": props(), "infinite": infinite_map(),
            "unmarked": unmarked(), "wrong": wrong(), "far": far(), "polygons": polygons(),
            "joints": joints(), "loose": loose(), "csv": packed_map(None)}
    for packing in PACKINGS:
        maps[packing or "base64"] = packed_map(packing)
    for name, content in maps.items():
        write_json(f"{name}.tmj", content)
        write_xml(f"{name}.tmx", content)
    write_xml("tiles/ground.tsx", ground_tiles())
    write_json("tiles/things.tsj", things())
    crate = {"properties": properties(body="dynamic", density="2.5")}
    write_xml("templates/crate.tx",
              template(crate, "../tiles/things.tsj", name="crate", gid=1, width=40, height=24))
    write_json("templates/plank.tj", {"type": "template", "object": {
        "width": 60, "height": 8, "rotation": 25, "properties": properties(body="dynamic")}})


if __name__ == "__main__":
    main()
