"""Converts Tiled's files from JSON to their XML form (.tmx, .tsx, .tx)."""

from xml.sax.saxutils import escape, quoteattr

LAYERS = {"tilelayer": "layer", "objectgroup": "objectgroup", "group": "group",
          "imagelayer": "imagelayer"}
# The fields of JSON that are no attributes in XML, but elements, or attributes of other elements.
CHILDREN = {"properties", "layers", "tilesets", "tiles", "objects", "objectgroup", "data", "chunks",
            "encoding", "compression", "tileoffset", "ellipse", "point", "capsule", "polygon", "polyline",
            "text", "imagewidth", "imageheight", "image", "tileset", "object", "startx", "starty",
            "draworder"}


def text_of(value):
    """A value as an attribute: booleans are 0 or 1."""
    return str(int(value)) if isinstance(value, bool) else str(value)


def element(name, json, children="", skip=()):
    """An element whose attributes are the fields of `json` but CHILDREN and `skip`."""
    attributes = "".join(f" {key}={quoteattr(text_of(value))}" for key, value in json.items()
                         if key not in CHILDREN and key not in skip)
    return f"<{name}{attributes}>{children}</{name}>\n" if children else f"<{name}{attributes}/>\n"


def properties_of(json):
    inner = "".join(element("property", {**entry, "value": str(entry["value"]).lower()
                                         if isinstance(entry["value"], bool) else entry["value"]})
                    for entry in json.get("properties", []))
    return f"<properties>\n{inner}</properties>\n" if inner else ""


def object_of(json):
    children = properties_of(json)
    for shape in ("ellipse", "point", "capsule"):
        if json.get(shape):
            children += f"<{shape}/>\n"
    for line in ("polygon", "polyline"):
        if line in json:
            points = " ".join(f"{p['x']},{p['y']}" for p in json[line])
            children += f'<{line} points="{points}"/>\n'
    if "text" in json:
        children += f"<text>{escape(json['text']['text'])}</text>\n"
    return element("object", json, children)


def data_of(json):
    encoding = json.get("encoding", "csv")
    packing = f' compression="{json["compression"]}"' if json.get("compression") else ""
    words = lambda data: data if isinstance(data, str) else ",".join(map(str, data))
    inner = words(json["data"]) if "data" in json else "\n" + "".join(
        element("chunk", chunk, words(chunk["data"])) for chunk in json["chunks"])
    return f'<data encoding="{encoding}"{packing}>{inner}</data>\n'


def layer_of(json):
    children = properties_of(json)
    if json["type"] == "tilelayer":
        children += data_of(json)
    children += "".join(map(object_of, json.get("objects", [])))
    children += "".join(map(layer_of, json.get("layers", [])))
    return element(LAYERS[json["type"]], json, children, skip=("type",))


def tile_of(json):
    children = properties_of(json)
    if "imagewidth" in json:
        children += element("image", {"source": json["image"], "width": json["imagewidth"],
                                      "height": json["imageheight"]})
    if "objectgroup" in json:
        objects = "".join(map(object_of, json["objectgroup"]["objects"]))
        children += f'<objectgroup draworder="index">\n{objects}</objectgroup>\n'
    return element("tile", json, children)


def tileset_of(json):
    children = properties_of(json)
    if "tileoffset" in json:
        children = element("tileoffset", json["tileoffset"]) + children
    children += "".join(map(tile_of, json.get("tiles", [])))
    return element("tileset", json, children, skip=("type",))


def xml_of(json):
    """The text of a map, a tileset or a template."""
    kind = json["type"]
    if kind == "tileset":
        body = tileset_of(json)
    elif kind == "template":
        inner = (tileset_of(json["tileset"]) if "tileset" in json else "")
        body = element("template", {}, inner + object_of(json["object"]))
    else:
        children = properties_of(json) + "".join(map(tileset_of, json.get("tilesets", [])))
        children += "".join(map(layer_of, json["layers"]))
        body = element("map", json, children, skip=("type",))
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}'
