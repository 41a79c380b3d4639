/**
 * Converts the XML form of Tiled's files (.tmx, .tsx, .tx) to the JSON that Tiled writes for the
 * same map, so that the rest of the reader handles one form only. The same rules as
 * demo/level/tmx.c.
 */
import type { XmlElement } from "@rgrove/parse-xml";
import { ThudError } from "../error.js";
import { type Json, type JsonRecord, numberOf } from "./values.js";

/**
 * The maximum nesting of elements. Chosen, so that a malicious file does not overflow the stack.
 */
const DEEPEST = 64;

/** How an element inside certain parents becomes JSON. */
interface Rule {
  /** The names of the parents, with spaces between them. */
  parents: string;
  element: string;
  /**
   * list: an element of a list of the parent; field: an object in a field of the parent; place: its
   * contents become those of the parent; flag: a field that is true; points: a list of points;
   * cell: a number in a list (the oldest form of cells).
   */
  kind: "list" | "field" | "place" | "flag" | "points" | "cell";
  /** The name of the field or list. */
  name: string;
  /** The value of the field "type" of layers. */
  type?: string;
}

const rule = (
  parents: string,
  element: string,
  kind: Rule["kind"],
  name = element,
  type?: string,
): Rule => ({ parents, element, kind, name, type });

/** All rules: elements without a rule for their parent are ignored. */
const RULES: Rule[] = [
  rule("map", "tileset", "list", "tilesets"),
  rule("template", "tileset", "field"),
  rule("map group", "layer", "list", "layers", "tilelayer"),
  rule("map group", "objectgroup", "list", "layers", "objectgroup"),
  rule("map group", "imagelayer", "list", "layers", "imagelayer"),
  rule("map group", "group", "list", "layers", "group"),
  rule("tileset", "tile", "list", "tiles"),
  rule("tileset", "tileoffset", "field"),
  rule("tile", "objectgroup", "field"),
  rule("tile", "image", "field"),
  rule("layer", "data", "place"),
  rule("data", "chunk", "list", "chunks"),
  rule("data chunk", "tile", "cell", "data"),
  rule("objectgroup", "object", "list", "objects"),
  rule("template", "object", "field"),
  rule("object", "ellipse", "flag"),
  rule("object", "point", "flag"),
  rule("object", "capsule", "flag"),
  rule("object", "text", "flag"),
  rule("object", "polygon", "points"),
  rule("object", "polyline", "points"),
  rule("map tileset tile layer objectgroup imagelayer group object", "properties", "place"),
  rule("properties", "property", "list", "properties"),
];

/** The attributes that the reader uses and that are numbers in JSON. */
const NUMBERS = new Set(
  (
    "width height tilewidth tileheight firstgid id gid x y rotation offsetx offsety"
  ).split(" "),
);
/** The attributes that the reader uses and that are text. */
const TEXTS = new Set(
  (
    "name type class value source template encoding compression orientation objectalignment " +
    "tilerendersize fillmode"
  ).split(" "),
);

/**
 * Parses XML. Rejects with an Error where it is malformed, with a ThudError "load" where the
 * package that parses it is not installed.
 */
export async function parseTmx(text: string): Promise<JsonRecord> {
  const { parseXml } = await import("@rgrove/parse-xml").catch((cause) => {
    const what = "a map in XML needs the package @rgrove/parse-xml";
    throw new ThudError("load", what, { cause });
  });
  const { root } = parseXml(text, { ignoreUndefinedEntities: false });
  if (!root) throw new ThudError("invalid", "it has no element");
  const json: JsonRecord = { type: root.name };
  if (root.name === "map") json.layers = [];
  putAttributes(json, root);
  walk(json, root, "", 1);
  return json;
}

/** Sets a field unless it is there already, and returns whether it did. */
function put(json: JsonRecord, name: string, value: Json): boolean {
  if (Object.hasOwn(json, name)) return false;
  json[name] = value;
  return true;
}

/** Copies the attributes that the reader uses to fields. */
function putAttributes(json: JsonRecord, { attributes }: XmlElement): void {
  for (const [name, text] of Object.entries(attributes)) {
    if (NUMBERS.has(name)) put(json, name, numberOf(text) ?? text);
    else if (TEXTS.has(name)) put(json, name, text);
  }
}

/** Appends a value to the list in a field; false where the field is no list. */
function putInList(json: JsonRecord, name: string, value: Json): boolean {
  put(json, name, []);
  const list = json[name];
  if (!Array.isArray(list)) return false;
  list.push(value);
  return true;
}

/** Converts an element's children. `textAs`: the field for its text, "": none. */
function walk(json: JsonRecord, element: XmlElement, textAs: string, depth: number): void {
  if (depth > DEEPEST) throw new ThudError("invalid", "its elements are nested too deeply");
  let text = "";
  for (const child of element.children) {
    if (child.type === "element") {
      text = "";
      enter(json, element.name, child as XmlElement, depth + 1);
    } else if (child.type === "text" || child.type === "cdata") {
      text += (child as unknown as { text: string }).text;
    }
  }
  if (textAs && text.trim() !== "") put(json, textAs, text);
  // A layer of an infinite map that has no tiles has no chunks in XML, but an empty list in JSON.
  else if (element.name === "data" && json.data === undefined && isInfinite(element))
    put(json, "chunks", []);
}

/** Whether the map of an element is infinite. */
function isInfinite({ document }: XmlElement): boolean {
  return document?.root?.attributes.infinite === "1";
}

/** Converts a child element by the rule for its parent; elements without a rule are ignored. */
function enter(around: JsonRecord, parent: string, child: XmlElement, depth: number): void {
  const found = RULES.find(
    ({ parents, element }) => element === child.name && parents.split(" ").includes(parent),
  );
  if (!found) return;
  const { kind, name, type } = found;
  const { attributes } = child;
  if (kind === "flag") put(around, name, true);
  else if (kind === "points") put(around, name, pointsOf(attributes.points ?? ""));
  else if (kind === "cell") putInList(around, name, numberOf(attributes.gid ?? "0") ?? -1);
  else {
    const json: JsonRecord = kind === "place" ? around : {};
    if (kind === "list" && !putInList(around, name, json)) return;
    if (kind === "field" && !put(around, name, json)) return;
    if (type) {
      put(json, "type", type);
      if (type === "objectgroup") put(json, "objects", []);
      if (type === "group") put(json, "layers", []);
    }
    putAttributes(json, child);
    if (child.name === "property") putTypedValue(json);
    const isData = child.name === "data" || child.name === "chunk";
    walk(json, child, isData ? "data" : child.name === "property" ? "value" : "", depth);
  }
}

/** Converts the value of a custom property to the property's type. */
function putTypedValue(property: JsonRecord): void {
  const { type, value } = property;
  if (typeof value !== "string") return;
  // A property that refers to an object has the object's id.
  if (type === "int" || type === "float" || type === "object") property.value = numberOf(value) ?? value;
  else if (type === "bool" && (value === "true" || value === "false")) property.value = value === "true";
}

/** The points of a text such as "0,0 16,-8". A wrong pair becomes {}, which is reported later. */
function pointsOf(text: string): Json[] {
  const pairs = text.split(/[ \t\r\n]+/).filter((pair) => pair !== "");
  return pairs.map((pair) => {
    const comma = pair.indexOf(",");
    const x = comma < 0 ? null : numberOf(pair.slice(0, comma));
    const y = comma < 0 ? null : numberOf(pair.slice(comma + 1));
    return x === null || y === null ? {} : { x, y };
  });
}
