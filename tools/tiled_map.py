"""Builds and writes maps of the Tiled editor, for tools/make_levels.py.

It gives the same files each time. assets/levels/README.md describes the properties."""

import json
import math
import re
from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent / "assets"
LEVELS = ASSETS / "levels"
TILE = 32  # pixels, and one metre

EMPTY, STONE, BRICK, ICE, GRASS = range(5)  # tile numbers, as cells have them


def properties(**values):
    """Custom properties in Tiled's form, sorted by name as the editor does."""
    kinds = {bool: "bool", int: "int", float: "float", str: "string"}
    return [{"name": name, "type": kinds[type(value)], "value": value}
            for name, value in sorted(values.items())]


class Map:
    """A map under construction. Arguments are in tiles from its lower left corner, with y up, as in
    the world; the file has pixels, with y down. `custom` and keyword arguments `custom` are custom
    properties."""

    def __init__(self, columns, rows, tile=TILE, **custom):
        self.columns, self.rows, self.tile = columns, rows, tile
        self.custom = custom
        self.layers, self.next_object = [], 1

    def pixel(self, x, y):
        """A place in pixels."""
        return round(x * self.tile, 3), round((self.rows - y) * self.tile, 3)

    def object_layer(self, name, **custom):
        """Adds a layer; returns its list of objects, which the functions below call `layer`."""
        layer = {"draworder": "topdown", "id": len(self.layers) + 1, "name": name, "objects": [],
                 "opacity": 1, "properties": properties(**custom), "type": "objectgroup",
                 "visible": True, "x": 0, "y": 0}
        self.layers.append(layer)
        return layer["objects"]

    def tile_layer(self, name, cells, **custom):
        """Adds a layer of tiles. `cells`: tile numbers by (column, row from below)."""
        data = [cells.get((i, self.rows - 1 - j), EMPTY)
                for j in range(self.rows) for i in range(self.columns)]
        self.layers.append({"data": data, "height": self.rows, "id": len(self.layers) + 1,
                            "name": name, "opacity": 1, "properties": properties(**custom),
                            "type": "tilelayer", "visible": True, "width": self.columns,
                            "x": 0, "y": 0})

    def add(self, layer, x, y, width=0, height=0, rotation=0, name="", kind="", **rest):
        """Adds an object whose upper left corner (before rotation) is at (x, y); returns its id."""
        custom = rest.pop("custom", {})
        px, py = self.pixel(x, y)
        entry = {"height": round(height * self.tile, 3), "id": self.next_object, "name": name,
                 "rotation": round(rotation, 3), "type": kind, "visible": True,
                 "width": round(width * self.tile, 3), "x": px, "y": py, **rest}
        if custom:
            entry["properties"] = properties(**custom)
        self.next_object += 1
        layer.append(entry)
        return entry["id"]

    def box(self, layer, x, y, width, height, degrees=0, **rest):
        """Adds a box with its centre at (x, y), turned clockwise. Tiled turns objects about their
        upper left corner, which is computed here."""
        a = math.radians(-degrees)
        corner_x = -width / 2 * math.cos(a) - height / 2 * math.sin(a)
        corner_y = -width / 2 * math.sin(a) + height / 2 * math.cos(a)
        return self.add(layer, x + corner_x, y + corner_y, width, height, degrees, **rest)

    def circle(self, layer, x, y, radius, **rest):
        return self.add(layer, x - radius, y + radius, 2 * radius, 2 * radius, ellipse=True, **rest)

    def spawn(self, layer, x, y):
        self.add(layer, x, y, name="spawn", kind="spawn", point=True)

    def line(self, layer, points, shape="polyline", **rest):
        """Adds a polyline or a polygon; returns its id."""
        x0, y0 = points[0]
        line = [{"x": round((x - x0) * self.tile, 3), "y": round((y0 - y) * self.tile, 3)}
                for x, y in points]
        return self.add(layer, x0, y0, **{shape: line}, **rest)

    def tie(self, layer, kind, places, a=None, b=None, name="", **custom):
        """Adds a joint between the objects a and b, or the world and b: at one place, or along a
        line between two. Returns its id."""
        if len(places) == 1:
            self.add(layer, *places[0], name=name, kind=kind, point=True)
        else:
            self.line(layer, places, name=name, kind=kind)
        refers = [{"name": key, "type": "object", "value": value}
                  for key, value in (("a", a), ("b", b)) if value is not None]
        layer[-1]["properties"] = sorted(refers + properties(**custom),
                                         key=lambda entry: entry["name"])
        return layer[-1]["id"]

    def write(self, name):
        """Writes the map to assets/levels."""
        uses_tiles = any(layer["type"] == "tilelayer" for layer in self.layers)
        text = json.dumps({
            "compressionlevel": -1, "height": self.rows, "infinite": False, "layers": self.layers,
            "nextlayerid": len(self.layers) + 1, "nextobjectid": self.next_object,
            "orientation": "orthogonal", "properties": properties(**self.custom),
            "renderorder": "right-down", "tiledversion": "1.10.2", "tileheight": self.tile,
            "tilesets": [tileset()] if uses_tiles else [], "tilewidth": self.tile, "type": "map",
            "version": "1.10", "width": self.columns}, indent=1)
        # Lists of numbers, and points, are on one line each, as the editor writes them.
        text = re.sub(r"\[[\d\s,]+\]", lambda m: re.sub(r"\s+", " ", m.group()), text)
        text = re.sub(r'\{\s+"x": (\S+),\s+"y": (\S+)\s+\}', r'{ "x": \1, "y": \2 }', text)
        (LEVELS / f"{name}.tmj").write_text(text + "\n", encoding="utf-8")


def tileset():
    """The tileset of tiles.png, which is in the map's own file."""
    return {"columns": 4, "firstgid": 1, "image": "tiles.png", "imageheight": TILE,
            "imagewidth": 4 * TILE, "margin": 0, "name": "tiles",
            "properties": properties(solid=True), "spacing": 0, "tilecount": 4,
            "tileheight": TILE,
            "tiles": [{"id": ICE - 1, "properties": properties(friction=0.02)},
                      {"id": GRASS - 1, "properties": properties(solid=False)}],
            "tilewidth": TILE}
